// A verdict as JSON: one field per member, left out if it does not apply.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <glassbox/render/trace/verdict.h>

namespace glassbox {

nlohmann::ordered_json to_json(const TriangleVerdict& verdict);
nlohmann::ordered_json to_json(const SceneVerdict& verdict);
nlohmann::ordered_json to_json(const Miss& miss);

}  // namespace glassbox
