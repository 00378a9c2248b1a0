// The plan of a picture, as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/plan/plan.h>

namespace glassbox::app {

// The plan of the whole picture, then of its groups of draws: only a few groups, those with most
// triangles first.
std::string plan_text(const Scene& scene, const Plan& plan, const PlannedEye& eye);

// All groups of draws, with the instances in each.
nlohmann::ordered_json to_json(const Plan& plan, const PlannedEye& eye);

}  // namespace glassbox::app
