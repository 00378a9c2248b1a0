#include "labs/framework/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace glassbox::labs {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// One end to read, one to write; both closed at the end.
struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    read = ends[0];
    write = ends[1];
  }
  ~Pipe() {
    close_read();
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_read() { close_end(read); }
  void close_write() { close_end(write); }

private:
  static void close_end(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

// After fork: nothing but calls that are safe in the child of a program with threads.
[[noreturn]] void become(char* const* argv, const Pipe& said, const Pipe& answers,
                         const Pipe& failure) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY);
  // The pipes' ends may lie on the numbers they are to have; moved up first, none overwrites another.
  constexpr int kAbove = 10;
  const int out = fcntl(said.write, F_DUPFD_CLOEXEC, kAbove);
  const int data = fcntl(answers.write, F_DUPFD_CLOEXEC, kAbove);
  const int why = fcntl(failure.write, F_DUPFD_CLOEXEC, kAbove);
  if (nothing >= 0) dup2(nothing, 0);
  dup2(out, 1);
  dup2(out, 2);
  dup2(data, kAnswersFd);
  execvp(argv[0], argv);
  const int error = errno;
  [[maybe_unused]] const auto written = write(why, &error, sizeof error);
  _exit(127);
}

// What can be read without waiting; whether the pipe is at its end.
bool drain(int fd, std::string& text, std::size_t limit, bool& over) {
  std::array<char, 65536> buffer;
  const ssize_t got = read(fd, buffer.data(), buffer.size());
  if (got < 0) return errno != EINTR && errno != EAGAIN;
  if (got == 0) return true;
  const std::size_t room = limit - std::min(limit, text.size());
  text.append(buffer.data(), std::min(room, std::size_t(got)));
  if (std::size_t(got) > room) over = true;
  return false;
}

// Until both pipes are closed, the child has ended, or it is told to end.
void collect(pid_t child, const Pipe& said, const Pipe& answers, const ProcessLimits& limits,
             Clock::time_point start, ProcessOutcome& outcome) {
  bool said_open = true, answers_open = true, ended = false, said_over = false;
  while (said_open || answers_open) {
    std::array<pollfd, 2> ends{pollfd{said_open ? said.read : -1, POLLIN, 0},
                               pollfd{answers_open ? answers.read : -1, POLLIN, 0}};
    const int ready = poll(ends.data(), ends.size(), 20);
    if (ready > 0) {
      if (ends[0].revents != 0)
        said_open = !drain(said.read, outcome.said, limits.said_bytes, said_over);
      if (ends[1].revents != 0)
        answers_open =
            !drain(answers.read, outcome.answers, limits.answers_bytes, outcome.too_much);
    } else if (ended) {
      return;  // something the child started holds the pipes: it has nothing more to say
    }
    if (!ended) ended = waitpid(child, &outcome.status, WNOHANG) == child;
    outcome.timed_out = !ended && seconds_since(start) > limits.seconds;
    if (outcome.timed_out || outcome.too_much) break;
    if (ended) kill(-child, SIGKILL);
  }
  // Its output may be closed while it runs on.
  while (!ended && !outcome.timed_out && !outcome.too_much) {
    ended = waitpid(child, &outcome.status, WNOHANG) == child;
    if (ended) break;
    outcome.timed_out = seconds_since(start) > limits.seconds;
    poll(nullptr, 0, 2);
  }
  kill(-child, SIGKILL);
  if (!ended) waitpid(child, &outcome.status, 0);
}

}  // namespace

ProcessOutcome run_process(const std::vector<std::string>& argv, const ProcessLimits& limits) {
  ProcessOutcome outcome;
  Pipe said, answers, failure;
  if (said.read < 0 || answers.read < 0 || failure.read < 0) {
    outcome.why_not_started = std::strerror(errno);
    return outcome;
  }
  std::vector<char*> words;
  for (const std::string& word : argv) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const auto start = Clock::now();
  const pid_t child = fork();
  if (child < 0) {
    outcome.why_not_started = std::strerror(errno);
    return outcome;
  }
  if (child == 0) become(words.data(), said, answers, failure);
  setpgid(child, child);  // in both, whichever comes first
  said.close_write();
  answers.close_write();
  failure.close_write();
  int error = 0;
  if (read(failure.read, &error, sizeof error) == ssize_t(sizeof error)) {
    outcome.why_not_started = std::strerror(error);
    waitpid(child, nullptr, 0);
    return outcome;
  }
  outcome.started = true;
  collect(child, said, answers, limits, start, outcome);
  outcome.seconds = seconds_since(start);
  return outcome;
}

}  // namespace glassbox::labs
