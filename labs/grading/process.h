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
inline constexpr int kFilterFd = 5;       // bubblewrap reads the filter of system calls here

struct Launch {
  std::vector<std::string> command;
  std::vector<std::string> environment;
  std::filesystem::path directory;
  Limits limits;
  std::optional<uid_t> user;  // the user to run as; only root may choose it
  SystemCallFilter filter;    // empty: no filter
  bool in_bubblewrap = false;
  int file_rules = -1;  // FileRules::descriptor(); -1: no rules
  int input = -1;       // standard input; -1: it is empty
};

// Runs the process as the leader of a session of its own. The whole session is killed when the time
// or the output is used up and when the process ends; it does not outlive the caller. Core files
// are off and the process cannot gain new privileges.
RunOutcome launch(const Launch& launch);

}  // namespace glassbox::labs::grading
