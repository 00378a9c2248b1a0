#include "app/report/whole_run.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include "app/report/exit_codes.h"

namespace glassbox::app {

namespace {

// To read from a closed standard input, and to write to a closed output, stays the error that it was.
void keep_open(int stream) {
  if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) return;
  static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

int refuse_output(int error) {
  return refuse({"standard output", "", std::string("cannot be written: ") + std::strerror(error),
                 error == ENOSPC || error == EFBIG ? "make room or write to another disk"
                                                   : "send it to what can be written"});
}

// oneTBB's workers start each other, so that an error in it reaches no caller.
[[noreturn]] void end_in_words() noexcept {
  int exit_code = kFailure;
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::exception& error) {
    exit_code = tell(error);
  } catch (...) {
    fmt::print(stderr, "glassbox: an error without a name\n");
  }
  std::_Exit(exit_code);
}

}  // namespace

void begin_run() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) keep_open(stream);
  std::signal(SIGXFSZ, SIG_IGN);
  std::set_terminate(end_in_words);
}

int end_run(int exit_code) {
  if (exit_code == kBadInput) return exit_code;  // which is told
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  return refuse_output(errno != 0 ? errno : EIO);
}

int tell(const std::exception& error) {
  const int reason = errno;
  if (std::ferror(stdout) != 0) return refuse_output(reason);
  const std::string_view what = error.what();
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    fmt::print(stderr, "glassbox: out of memory; render a smaller --size or a smaller scene\n");
  } else if (what.find("pthread") != what.npos) {
    fmt::print(stderr,
               "glassbox: a thread cannot be started ({}); give fewer --threads, or allow more "
               "processes and memory\n",
               printable(what, kLongestMessage));
  } else {
    fmt::print(stderr, "glassbox: {}\n", printable(what, kLongestMessage));
  }
  return kFailure;
}

}  // namespace glassbox::app
