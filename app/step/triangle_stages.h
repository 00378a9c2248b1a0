// The stages of a stepped triangle as text, one after the other.
#pragma once

#include <string>
#include <vector>

#include "app/step/stepped_triangle.h"

namespace glassbox::app {

struct StageText {
  std::string name;  // one word, to jump to: "clip"
  std::string text;  // ends with a line break
};

// From "object" to "picture"; fewer where the triangle ends before.
std::vector<StageText> stage_texts(const Scene& scene, const SteppedTriangle& stepped,
                                   const StepTarget& target, bool bits);

}  // namespace glassbox::app
