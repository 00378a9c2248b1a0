// Stepping through a triangle's stages by hand, at a prompt: next, back, jump, another camera or triangle, and what that changes.
#pragma once

#include <string>
#include <vector>

#include "app/step/triangle_stages.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// What is looked at: the words of the picture options, "--eye 1,2,3", and the triangle.
struct StepChoice {
  std::vector<std::string> words;
  StepTarget target;
};

// Reads commands until "quit" or the end of the input, and writes to standard output. `terminal`: with line editing, history and
// completion; otherwise from any standard input.
void step_by_hand(const Scene& scene, const StepChoice& choice, std::vector<StageText> stages,
                  bool bits, bool terminal);

}  // namespace glassbox::app
