// Runs another program to its end and returns its output.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace glassbox::test {

struct Outcome {
  int exit_code = -1;  // 128 + the signal's number if a signal killed it
  std::string out;     // standard output
  std::string err;     // standard error
};

namespace detail {

inline std::string contents(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char block[4096];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file)) text.append(block, n);
  return text;
}

}  // namespace detail

// Runs `program` in `directory`. Its outputs go through files, so that no pipe can fill up.
// `meanwhile` is called with the id of its process while it runs.
inline Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                           const std::string& directory,
                           const std::function<void(pid_t)>& meanwhile = {}) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::FILE* out = std::tmpfile();
  std::FILE* err = std::tmpfile();
  if (out == nullptr || err == nullptr) throw std::runtime_error("no temporary file");

  // Until it runs the other program, the child process has the signal handlers of the tests: SIGINT
  // is blocked until then.
  sigset_t interrupt, before;
  ::sigemptyset(&interrupt);
  ::sigaddset(&interrupt, SIGINT);
  ::sigprocmask(SIG_BLOCK, &interrupt, &before);
  const pid_t child = ::fork();
  if (child != 0) ::sigprocmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    ::signal(SIGINT, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    ::dup2(::open("/dev/null", O_RDONLY), 0);
    ::dup2(::fileno(out), 1);
    ::dup2(::fileno(err), 2);
    if (::chdir(directory.c_str()) == 0) ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  if (meanwhile) meanwhile(child);
  int status = 0;
  ::waitpid(child, &status, 0);
  const Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                        detail::contents(out), detail::contents(err)};
  std::fclose(out);
  std::fclose(err);
  return outcome;
}

}  // namespace glassbox::test
