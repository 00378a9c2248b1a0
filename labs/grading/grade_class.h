// Grades a class: each submission in its own process, several at the same time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace glassbox::labs::grading {

struct ClassRequest {
  std::vector<std::string> names;  // names of the submissions
  int jobs = 1;
  // Returns the command that grades one submission, the program first.
  std::function<std::vector<std::string>(const std::string& name)> command;
  // Called when the process that grades `name` has ended, in the order in which the processes end.
  // `fine`: its exit status is 0; `printed`: what it wrote to standard error.
  std::function<void(const std::string& name, bool fine, const std::string& printed)> ended;
};

// Returns when all processes have ended. They also end when the caller ends, for any reason.
void grade_class(const ClassRequest& request);

}  // namespace glassbox::labs::grading
