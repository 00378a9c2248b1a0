// One submission, from its file to its points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/judge.h"
#include "labs/framework/sources.h"
#include "labs/grading/kit.h"
#include "labs/grading/limits.h"
#include "labs/grading/sandbox.h"

namespace glassbox::labs::grading {

struct Graded {
  LabResult result;
  std::string outcome;  // "graded", "missing file", "compile error", "compile timeout", ...
  std::string said;     // what the compiler said, or why the file was refused
  // Of each check: "passed", "wrong answer", "crash (SIGSEGV)", "timeout", ...
  std::vector<std::string> names;
};

// The lab with no points given, and `outcome` for every check: what a result says until it is known.
Graded nothing_yet(const Lab& lab, const std::string& outcome);

// Compiles in `build`, an empty directory of its own, and puts every check to a process of its own. What goes wrong in a
// submission is a result, not an error.
Graded grade(const Lab& lab, const std::filesystem::path& submission, const Sandbox& sandbox,
             const Kit& kit, const std::filesystem::path& build, const Limits& limits);

// What became of a check, from its verdict and from how its first process ended.
std::string name_of(const CheckResult& check, const std::vector<RunOutcome>& processes);

}  // namespace glassbox::labs::grading
