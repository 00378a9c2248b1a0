// One process under limits, followed to its end.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "labs/framework/process.h"
#include "labs/framework/run_check.h"
#include "labs/grading/limits.h"
#include "labs/grading/system_calls.h"

namespace glassbox::labs::grading {

// Descriptors that a process is given besides the standard ones and kAnswersFd.
inline constexpr int kNotesFd = 4;   // witness.cpp
inline constexpr int kFilterFd = 5;  // for bubblewrap, which puts the filter in force itself

struct Launch {
  std::vector<std::string> command;
  std::vector<std::string> environment;
  std::filesystem::path directory;
  Limits limits;
  std::optional<uid_t> user;  // to become; only root may
  SystemCallFilter filter;    // none if empty
  bool in_bubblewrap = false;
  int file_rules = -1;  // FileRules::descriptor()
  int input = -1;       // standard input; none: it is empty
};

// The process leads a session of its own, which is killed as a whole when its time or output is
// spent and when it ends; it does not outlive the caller. Core files are off and no new privileges can be had.
RunOutcome launch(const Launch& launch);

}  // namespace glassbox::labs::grading
