// Stepping through the stages by hand, on a terminal: next, back, jump, another camera or triangle, and what that changes.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/step/line_reader.h"
#include "app/step/stage_text.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// What is looked at: the words of the picture options, "--eye 1,2,3", and the triangle.
struct StepChoice {
  std::vector<std::string> words;
  StepTarget target;
};

struct Staged {
  StepChoice choice;
  std::vector<StageText> stages;
};

// Makes the stages again for more words: picture options, --triangle, --pick and --vertex.
using Restage =
    std::function<Result<Staged>(const StepChoice& choice, const std::vector<std::string>& more)>;

// The options that a restage takes, by their names, with the words that each may have; none for numbers.
using OptionWords = std::map<std::string, std::vector<std::string>>;

// Reads commands until "quit" or the end of the lines, and writes to standard output.
void step_by_hand(LineReader& lines, Staged staged, const Restage& restage);

// What may stand at the end of a command, for completion.
std::vector<std::string> step_candidates(const std::vector<std::string>& words,
                                         const OptionWords& options);

// What has changed between two texts, as lines that begin with "- " and "+ "; lines that both have stand between them.
std::string changed_lines(const std::string& before, const std::string& after);

}  // namespace glassbox::app
