// Checks a student's folder as a grader would, in the sandbox, once or repeatedly.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/report/scratch_directory.h"
#include "labs/commands/find_lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/grade.h"
#include "labs/grading/sandbox.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct CheckOptions {
  bool hidden = false;
  bool sanitize = false;
  double seconds = 10;  // time limit of each check
  std::size_t memory_mib = 512;
  std::optional<labs::grading::Confinement> confinement = {};
};

struct CheckOutcome {
  labs::grading::GradedSubmission graded;
  // a program for the debugger, built with -O0 -g, if a check failed; else empty
  std::string runner;
  double seconds = 0;
};

class LabChecker {
public:
  // Chooses the sandbox, and makes the kit that submissions are compiled with, unless an earlier
  // one is found.
  static Result<std::unique_ptr<LabChecker>> open(const LabFolder& folder,
                                                  const CheckOptions& options);

  Result<CheckOutcome> check();
  const std::filesystem::path& student() const { return folder_.student; }

private:
  LabChecker(const LabFolder& folder, const CheckOptions& options)
      : folder_(folder), options_(options) {}
  Result<void> prepare();
  Result<std::string> debugger_program(const std::string& text);

  LabFolder folder_;
  CheckOptions options_;
  labs::Sources sources_;
  labs::Lab lab_;  // with the points of points.json
  std::vector<std::string> warnings_;
  ScratchDirectory scratch_;
  std::optional<labs::grading::Sandbox> sandbox_;
  labs::grading::BuildKit kit_;
  int builds_ = 0;
};

}  // namespace glassbox::labs
