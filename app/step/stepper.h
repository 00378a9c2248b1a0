// Stepping through the stages by hand, on a terminal: next, back, jump, another camera, and what that changes.
#pragma once

#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "app/step/stage_text.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// Makes the stages again for other words of picture options, "--eye 1,2,3".
using Restage =
    std::function<Result<std::vector<StageText>>(const std::vector<std::string>& words)>;

// Reads commands from `in` until "quit" or its end, and writes to standard output. `words` are the picture options that made
// `stages`; what the user adds comes after them.
void step_by_hand(std::istream& in, std::vector<StageText> stages, std::vector<std::string> words,
                  const Restage& restage);

// What has changed between two texts, as lines that begin with "- " and "+ "; lines that both have stand between them.
std::string changed_lines(const std::string& before, const std::string& after);

}  // namespace glassbox::app
