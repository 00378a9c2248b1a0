#include "cli/process/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "cli/process/follow.h"

namespace glassbox {

namespace {

// Runs in the child after fork: only calls that are safe there in a program with threads.
[[noreturn]] void become(char* const* argv, const Pipe& said, const Pipe& answers,
                         const Pipe& failure) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0) dup2(nothing, 0);
  dup2(said.write.get(), 1);
  dup2(said.write.get(), 2);
  dup2(answers.write.get(), kAnswersFd);
  execvp(argv[0], argv);
  const int error = errno;
  [[maybe_unused]] const auto written = write(failure.write.get(), &error, sizeof error);
  _exit(127);
}

}  // namespace

ProcessOutcome run_process(const std::vector<std::string>& argv, const ProcessLimits& limits) {
  ProcessOutcome outcome;
  Pipe said, answers, failure;
  std::vector<char*> words;
  for (const std::string& word : argv) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const bool pipes = said.valid() && answers.valid() && failure.valid();
  const pid_t child = pipes ? fork() : -1;
  if (child < 0) {
    outcome.why_not_started = std::strerror(errno);
    return outcome;
  }
  if (child == 0) become(words.data(), said, answers, failure);
  for (Pipe* pipe : {&said, &answers, &failure}) pipe->write.close();
  std::array<Stream, 2> streams{Stream{&answers, limits.answers_bytes, limits.answers_bytes},
                                Stream{&said, limits.said_bytes}};
  const Followed followed = follow(child, streams, limits.seconds);
  int error = 0;
  if (read(failure.read.get(), &error, sizeof error) == ssize_t(sizeof error)) {
    outcome.why_not_started = std::strerror(error);
    return outcome;
  }
  outcome.started = true;
  outcome.too_much = streams[0].too_much();
  outcome.timed_out = !followed.ended && !outcome.too_much;
  outcome.status = followed.status;
  outcome.answers = std::move(streams[0].text);
  outcome.said = std::move(streams[1].text);
  outcome.seconds = followed.seconds;
  return outcome;
}

}  // namespace glassbox
