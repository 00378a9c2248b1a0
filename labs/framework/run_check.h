// Runs a check of a lab in a process of its own and collects the answers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/protocol.h"

namespace glassbox::labs {

struct RunLimits {
  double seconds = 10;                               // wall-clock time of a process
  std::size_t output_bytes = std::size_t(64) << 20;  // for answers; the rest is cut off
  // how much is kept of standard output and standard error
  std::size_t printed_bytes = std::size_t(64) << 10;
};

struct RunRequest {
  std::filesystem::path program;       // the runner
  std::vector<std::string> arguments;  // without the program's name and without --out-fd
  RunLimits limits;
};

// How a process ended, and what it had written by then.
struct RunOutcome {
  enum class Ending {
    kExit,
    kSignal,
    kTimeout,
    kTooMuchOutput,
    kOutOfMemory,
    kForbidden,
    kNotStarted
  };
  Ending ending = Ending::kNotStarted;
  int code = 0;  // the exit status or the signal
  // why the process was not started, or which forbidden call or limit stopped it; may be empty
  std::string detail;
  std::string answers;  // what the process wrote to the descriptor of the answers
  std::string printed;  // its standard output and standard error
  double seconds = 0;
};

// Runs processes. Students run their own code with LocalRunner; a grader uses a sandbox instead.
class Runner {
public:
  virtual ~Runner() = default;
  virtual RunOutcome run(const RunRequest& request) = 0;
};

// Runs a child process with a limit on time and output, but without a sandbox.
class LocalRunner : public Runner {
public:
  RunOutcome run(const RunRequest& request) override;
};

// How the process ended: "killed by signal 11 (SIGSEGV)", "exit status 3", "still running after 10
// seconds".
std::string ending_text(const RunOutcome& outcome, const RunLimits& limits);

// Runs a check and collects all its answers. A crash costs only the case in which it happened: the
// process is started again from the next case, at most kMaxRestarts times. A process that is out
// of time, memory or output is not started again.
inline constexpr int kMaxRestarts = 16;
//
// Unless `inputs` is 0, only the first so many inputs of each class of generated inputs are run.
CheckAnswers run_check(Runner& runner, const std::filesystem::path& program,
                       const std::string& check, std::size_t cases, const RunLimits& limits,
                       std::size_t inputs = 0);

// Runs some of the inputs of a generated class (choices.h): those from number `first` to `end` - 1,
// or those that the given choices make. The answer is that of the class, a batch (batch.h). If the
// process could not be started, the answer is kLimit, because no input is to blame.
struct SomeInputs {
  std::size_t first = 0, end = 0;
  std::vector<std::vector<std::uint64_t>> choices = {};  // empty: by their numbers
};
// The choices as a runner reads them: "1 0 2;3".
std::string choices_text(const std::vector<std::vector<std::uint64_t>>& choices);
CaseAnswer run_inputs(Runner& runner, const std::filesystem::path& program,
                      const std::string& check, std::size_t index, const SomeInputs& inputs,
                      const RunLimits& limits);

}  // namespace glassbox::labs
