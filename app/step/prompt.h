// A prompt at which the user steps through a triangle's stages: next, back, jump, other cameras or
// triangles, and what they change.
#pragma once

#include <string>
#include <vector>

#include "app/step/triangle_stages.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// What is examined: the words of the picture options, such as "--eye 1,2,3", and the triangle.
struct StepChoice {
  std::vector<std::string> words;
  StepTarget target;
};

// Reads commands until "quit" or the end of the input, and writes to standard output. If
// `terminal`, with line editing, history and completion; otherwise from any standard input.
void step_by_hand(const Scene& scene, const StepChoice& choice, std::vector<StageText> stages,
                  bool bits, bool terminal);

}  // namespace glassbox::app
