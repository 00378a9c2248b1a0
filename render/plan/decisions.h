// The plan in words: which stages run for a draw and which do not, and why that changes no byte.
#pragma once

#include <string>
#include <vector>

#include <glassbox/render/plan/plan.h>

namespace glassbox {

struct Decision {
  const char* stage = "";
  bool needed = true;
  // The proof that the stage is not needed, or the reason why it is; the same words for all draws
  // that it applies to.
  std::string because;
  std::string numbers;  // the numbers of this draw; empty where there are none
};

// Returns the decisions about the whole picture.
std::vector<Decision> decisions(const Plan& plan, const PlannedEye& eye);

// Returns the decisions about one draw, in the order of the stages. If the draw is left out as a
// whole, there is only the first decision.
std::vector<Decision> decisions(const Plan& plan, const PlannedEye& eye, std::size_t draw);

// Describes how the draw is drawn, for example "in SIMD lanes", or "staged, tile by tile: " and the
// reason.
std::string describe_method(const DrawMethod& method);

}  // namespace glassbox
