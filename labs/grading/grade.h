// Grades one submission, from its file to its points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/judge_check.h"
#include "labs/framework/sources.h"
#include "labs/grading/build_kit.h"
#include "labs/grading/limits.h"
#include "labs/grading/sandbox.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

struct GradedSubmission {
  LabResult result;
  std::string outcome;   // "graded", "missing file", "compile error", "compile timeout", ...
  std::string messages;  // the compiler's messages, or why the file was refused
  // The outcome of each check: "passed", "wrong answer", "crash (SIGSEGV)", "timeout", ...
  std::vector<std::string> check_outcomes;
};

struct GradeRequest {
  const Lab& lab;  // including its points (framework/lab_points.h)
  const Sandbox& sandbox;
  const BuildKit& kit;
  std::filesystem::path build;  // an empty directory for this submission alone
  Limits limits = {};
  double total_seconds = 0;  // for all checks together; 0: no limit
  bool hidden = true;        // whether hidden checks are run too; if not, the result has none
  std::size_t max_parallel_checks = 1;
  CompileOptions compile_options = {};
};

// The result of a lab that has not been graded: no points, and `outcome` for every check; without
// `hidden` it has the visible checks only.
GradedSubmission ungraded_submission(const Lab& lab, const std::string& outcome,
                                     bool hidden = true);

// Compiles the submission and runs every check in its own process. `submission` is the text, or the
// reason why there is none. An error in a submission is a result, not an error of this function. A
// check that is answered as the starter answers it counts as not written yet.
GradedSubmission grade(const GradeRequest& request, const Result<std::string>& submission);

// The name of a check's outcome, from its verdict and from how its first process ended.
std::string check_outcome(const CheckResult& check, const std::vector<RunOutcome>& processes);

}  // namespace glassbox::labs::grading
