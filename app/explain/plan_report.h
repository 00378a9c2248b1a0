// The plan of a picture for people and for machines.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/plan/plan.h>

namespace glassbox::app {

// The whole picture, then its draws in groups, those with most triangles first and not more than a few of them.
std::string plan_text(const Scene& scene, const Plan& plan, const PlannedEye& eye);

// All groups, with the instances that are in each.
nlohmann::ordered_json to_json(const Plan& plan, const PlannedEye& eye);

}  // namespace glassbox::app
