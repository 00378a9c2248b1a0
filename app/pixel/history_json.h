// A pixel's history as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/history.h>

namespace glassbox {

nlohmann::ordered_json to_json(const Scene& scene, const PixelHistory& history);

}  // namespace glassbox
