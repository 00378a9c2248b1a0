// The plan in words: what runs for a draw and what does not, and why that changes no byte.
#pragma once

#include <string>
#include <vector>

#include <glassbox/render/plan/plan.h>

namespace glassbox {

struct Decision {
  const char* stage = "";
  bool needed = true;
  // The proof, or what stands against it; the same words for all draws that it holds for.
  std::string because;
  std::string numbers;  // those of this draw; empty where there are none
};

// The decisions about the whole picture.
std::vector<Decision> decisions(const Plan& plan, const PlannedEye& eye);

// The decisions about one draw, in the order of the stages. Only the first says something where the draw is not drawn.
std::vector<Decision> decisions(const Plan& plan, const PlannedEye& eye, std::size_t draw);

// "triangles over lanes", "each triangle made ready by itself, because ...": how the draw is drawn.
std::string way_of(const DrawMethod& method);

}  // namespace glassbox
