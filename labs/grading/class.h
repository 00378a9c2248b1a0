// A class: every submission by a process of its own, several at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace glassbox::labs::grading {

struct ClassRequest {
  std::vector<std::string> names;  // of the submissions
  int jobs = 1;
  // The command that grades one, program first.
  std::function<std::vector<std::string>(const std::string& name)> command;
  // Called when one has ended, in the order in which they end. `fine`: with exit status 0; `said`: its standard error.
  std::function<void(const std::string& name, bool fine, const std::string& said)> ended;
};

// Returns when all have ended. They end with the caller, whatever becomes of it.
void grade_class(const ClassRequest& request);

}  // namespace glassbox::labs::grading
