// The draws of a plan, those of which the same is said together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/render/plan/decisions.h>

namespace glassbox::app {

struct DrawGroup {
  std::string way;                   // over lanes, staged, not drawn
  std::vector<Decision> decisions;   // with the numbers of the largest draw
  std::vector<std::uint32_t> draws;  // indices into the draw list, the largest first
  std::uint64_t triangles = 0;
};

// The group with most triangles first; of equal ones, the one that begins earlier.
std::vector<DrawGroup> group_draws(const Plan& plan, const PlannedEye& eye);

}  // namespace glassbox::app
