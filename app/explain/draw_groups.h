// The draws of a plan in groups: draws with the same decisions are reported together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/render/plan/decisions.h>

namespace glassbox::app {

struct DrawGroup {
  std::string way;                   // how they are drawn: over lanes, staged, not drawn
  std::vector<Decision> decisions;   // with the numbers of the largest draw
  std::vector<std::uint32_t> draws;  // indices into the draw list, the largest first
  std::uint64_t triangles = 0;
};

// The groups, that with most triangles first; of equal ones, that with the earlier first draw.
std::vector<DrawGroup> group_draws(const Plan& plan, const PlannedEye& eye);

}  // namespace glassbox::app
