#include <glassbox/compare/testing/run_diff.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace glassbox::golden {
namespace {

// A report on one pair has some kilobytes. What goes beyond this is read and dropped.
constexpr std::size_t kMaxText = std::size_t(1) << 20;

// Reads until the other end of the pipe is closed.
std::string read_all(int pipe) {
  std::string text;
  char part[4096];
  for (;;) {
    const ssize_t got = ::read(pipe, part, sizeof part);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    if (text.size() < kMaxText) text.append(part, std::size_t(got));
  }
}

// Starts the program with both outputs going to the pipe. Returns 0, or an error number.
int start(const std::string& program, const std::vector<std::string>& arguments, int pipe,
          pid_t& child) {
  std::vector<char*> words{const_cast<char*>(program.c_str()), const_cast<char*>("diff")};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  if (const int error = ::posix_spawn_file_actions_init(&actions)) return error;
  int error = ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    if (error == 0) error = ::posix_spawn_file_actions_adddup2(&actions, pipe, output);
  }
  if (error == 0) {
    error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  }
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

DiffRun not_run(const std::string& program, const std::string& why) {
  return {-1, program + " " + why +
                  "; install Glassbox, or name its program in the environment variable "
                  "GLASSBOX_PROGRAM\n"};
}

// Waits for the end of the program.
DiffRun ended(const std::string& program, pid_t child, std::string text) {
  int status = 0;
  pid_t got;
  do {
    got = ::waitpid(child, &status, 0);
  } while (got < 0 && errno == EINTR);
  if (got < 0) return not_run(program, std::string("was lost: ") + std::strerror(errno));
  if (!WIFEXITED(status)) return not_run(program, "was stopped by a signal:\n" + text);
  // Exit codes that glassbox diff does not have are those of another program, or of a broken one.
  if (WEXITSTATUS(status) > 2) {
    return not_run(program, "ended with " + std::to_string(WEXITSTATUS(status)) + ":\n" + text);
  }
  if (!text.empty() && text.back() != '\n') text += '\n';
  return {WEXITSTATUS(status), std::move(text)};
}

}  // namespace

DiffRun run_diff(const std::string& program, const std::vector<std::string>& arguments) {
  int ends[2];
  // Programs that other threads of the test start at the same time must not keep the pipe open.
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return not_run(program, std::string("has no pipe: ") + std::strerror(errno));
  }
  pid_t child = 0;
  const int error = start(program, arguments, ends[1], child);
  ::close(ends[1]);
  if (error != 0) {
    ::close(ends[0]);
    return not_run(program, std::string("cannot be started: ") + std::strerror(error));
  }
  std::string text = read_all(ends[0]);
  ::close(ends[0]);
  return ended(program, child, std::move(text));
}

}  // namespace glassbox::golden
