// The texts of all stages of a stepped triangle.
#pragma once

#include <string>
#include <vector>

#include "app/step/stepped_triangle.h"

namespace glassbox::app {

struct StageText {
  std::string name;  // one word, which the prompt can jump to: "clip"
  std::string text;  // ends with a line break
};

// The texts from "object" to "picture"; fewer if the triangle ends in an earlier stage.
std::vector<StageText> stage_texts(const Scene& scene, const SteppedTriangle& stepped,
                                   const StepTarget& target, bool bits);

}  // namespace glassbox::app
