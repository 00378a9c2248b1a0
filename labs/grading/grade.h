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

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

struct Graded {
  LabResult result;
  std::string outcome;  // "graded", "missing file", "compile error", "compile timeout", ...
  std::string said;     // what the compiler said, or why the file was refused
  // Of each check: "passed", "wrong answer", "crash (SIGSEGV)", "timeout", ...
  std::vector<std::string> names;
};

struct GradeRequest {
  const Lab& lab;  // with its points (framework/points.h)
  const Sandbox& sandbox;
  const Kit& kit;
  std::filesystem::path build;  // an empty directory of its own
  Limits limits = {};
  double total_seconds = 0;  // of all checks together; 0: no limit
  bool hidden = true;        // hidden checks too
  std::size_t at_a_time = 1;
  CompileWords words = {};
};

// The lab with no points given, and `outcome` for every check: what a result says until it is known.
Graded nothing_yet(const Lab& lab, const std::string& outcome);

// Compiles the submission, or the reason why there is none, and puts every check to a process of its own. What goes wrong in a
// submission is a result, not an error. A check that is answered as the starter answers it has not been written yet.
Graded grade(const GradeRequest& request, const Result<std::string>& submission);

// What became of a check, from its verdict and from how its first process ended.
std::string name_of(const CheckResult& check, const std::vector<RunOutcome>& processes);

}  // namespace glassbox::labs::grading
