#include "cli/process/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "cli/process/wait_for_process.h"

namespace glassbox {

namespace {

// Runs in the child process after fork: calls only functions that are safe there in a program with
// threads.
[[noreturn]] void run_in_child(char* const* argv, const Pipe& printed, const Pipe& answers,
                               const Pipe& failure) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0) dup2(nothing, 0);
  dup2(printed.write.get(), 1);
  dup2(printed.write.get(), 2);
  dup2(answers.write.get(), kAnswersFd);
  execvp(argv[0], argv);
  const int error = errno;
  [[maybe_unused]] const auto written = write(failure.write.get(), &error, sizeof error);
  _exit(127);
}

}  // namespace

ProcessOutcome run_process(const std::vector<std::string>& argv, const ProcessLimits& limits) {
  ProcessOutcome outcome;
  Pipe printed, answers, failure;
  std::vector<char*> words;
  for (const std::string& word : argv) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const bool pipes = printed.valid() && answers.valid() && failure.valid();
  const pid_t child = pipes ? fork() : -1;
  if (child < 0) {
    outcome.why_not_started = std::strerror(errno);
    return outcome;
  }
  if (child == 0) run_in_child(words.data(), printed, answers, failure);
  for (Pipe* pipe : {&printed, &answers, &failure}) pipe->write.close();
  std::array<Stream, 2> streams{Stream{&answers, limits.answers_bytes, limits.answers_bytes},
                                Stream{&printed, limits.printed_bytes}};
  const WaitResult result = wait_for_process(child, streams, limits.seconds);
  int error = 0;
  if (read(failure.read.get(), &error, sizeof error) == ssize_t(sizeof error)) {
    outcome.why_not_started = std::strerror(error);
    return outcome;
  }
  outcome.started = true;
  outcome.too_much = streams[0].exceeds_limit();
  outcome.timed_out = !result.ended && !outcome.too_much;
  outcome.status = result.status;
  outcome.answers = std::move(streams[0].text);
  outcome.printed = std::move(streams[1].text);
  outcome.seconds = result.seconds;
  return outcome;
}

}  // namespace glassbox
