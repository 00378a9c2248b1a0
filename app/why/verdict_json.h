// A verdict as JSON: every field by its own name, absent where it does not apply.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <glassbox/render/trace/verdict.h>

namespace glassbox {

nlohmann::ordered_json to_json(const TriangleVerdict& verdict);
nlohmann::ordered_json to_json(const SceneVerdict& verdict);
nlohmann::ordered_json to_json(const Miss& miss);

}  // namespace glassbox
