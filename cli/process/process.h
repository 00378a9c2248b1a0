// A child process with its output collected.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace glassbox {

struct ProcessLimits {
  double seconds = 60;
  std::size_t answers_bytes = 0;
  std::size_t printed_bytes = std::size_t(1) << 20;
};

struct ProcessOutcome {
  bool started = false;
  bool timed_out = false;
  bool too_much = false;  // the process wrote more answers than allowed
  int status = 0;         // the exit status that waitpid gives
  std::string why_not_started;
  std::string answers;  // from descriptor kAnswersFd
  std::string printed;  // standard output and standard error
  double seconds = 0;
};

inline constexpr int kAnswersFd = 3;

// Runs argv[0] with empty standard input; a bare name is looked up in PATH. The child leads a
// process group of its own, which is killed when the time is up or the child has ended, so that
// nothing it started goes on running.
ProcessOutcome run_process(const std::vector<std::string>& argv, const ProcessLimits& limits);

}  // namespace glassbox
