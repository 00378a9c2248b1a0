// Runs one process under limits and follows it to its end.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/process/process.h"
#include "labs/framework/run_check.h"
#include "labs/grading/limits.h"
#include "labs/grading/system_calls.h"

namespace glassbox::labs::grading {

// Descriptors that a process gets in addition to the standard ones and kAnswersFd.
inline constexpr int kCrashReportFd = 4;  // crash_reporter.cpp
inline constexpr int kFilterFd = 5;       // for bubblewrap, which installs the filter itself

struct Launch {
  std::vector<std::string> command;
  std::vector<std::string> environment;
  std::filesystem::path directory;
  Limits limits;
  std::optional<uid_t> user;  // the user to become; only root may change it
  SystemCallFilter filter;    // empty: no filter
  bool in_bubblewrap = false;
  int file_rules = -1;  // FileRules::descriptor()
  int input = -1;       // standard input; -1: it is empty
};

// Runs the process. It leads a session of its own, which is killed as a whole when its time or
// output is used up and when it ends; it does not outlive the caller. Core files are off and it
// cannot gain new privileges.
RunOutcome launch(const Launch& launch);

}  // namespace glassbox::labs::grading
