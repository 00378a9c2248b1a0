#include "cli/report/begin_and_end_run.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "cli/report/exit_codes.h"

namespace glassbox {

namespace {

// Opens the number of a closed standard stream again, such that using the stream still fails:
// reading from standard input, or writing to an output.
void keep_open(int stream) {
  if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) return;
  static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

int refuse_output(int error) {
  return refuse({"standard output", "", std::string("cannot be written: ") + std::strerror(error),
                 error == ENOSPC || error == EFBIG
                     ? "free some space or write to another disk"
                     : "send the output to a file or program that accepts it"});
}

bool is_about_threads(const std::exception& error) {
  return std::string_view(error.what()).find("pthread") != std::string_view::npos;
}

std::atomic<bool> a_worker_waits = false;

// For a thread that cannot continue while other threads can: waits until the process ends.
[[noreturn]] void wait_for_the_end() {
  a_worker_waits = true;
  for (;;) ::pause();
}

// Called for an exception that no function catches. oneTBB's worker threads start each other, so no
// caller catches the exception when one of them cannot be started. Such a worker has no task at
// that moment, and the other threads draw the picture. A worker that starts threads while the
// process ends may call a function of an object that is already destroyed; then this is called
// without an exception.
[[noreturn]] void end_in_words() noexcept {
  const bool is_main_thread = ::gettid() == ::getpid();
  const std::exception_ptr error = std::current_exception();
  if (!error && !is_main_thread) wait_for_the_end();
  int exit_code = kFailure;
  try {
    if (error) std::rethrow_exception(error);
  } catch (const std::exception& told) {
    if (is_about_threads(told) && !is_main_thread) wait_for_the_end();
    exit_code = report_exception(told);
  } catch (...) {
    fmt::print(stderr, "glassbox: an unknown error occurred\n");
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
  if (exit_code == kBadInput) return exit_code;  // the error has been reported already
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return refuse_output(errno != 0 ? errno : EIO);
  // Other worker threads may still be starting threads, which would crash in oneTBB's destructors.
  if (a_worker_waits) std::_Exit(exit_code);
  return exit_code;
}

int report_exception(const std::exception& error) {
  const int reason = errno;
  if (std::ferror(stdout) != 0) return refuse_output(reason);
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    fmt::print(stderr, "glassbox: out of memory; render a smaller --size or a smaller scene\n");
  } else if (is_about_threads(error)) {
    fmt::print(stderr,
               "glassbox: a thread cannot be started ({}); give fewer --threads, or allow more "
               "processes and memory\n",
               printable(error.what(), kLongestMessage));
  } else {
    fmt::print(stderr, "glassbox: {}\n", printable(error.what(), kLongestMessage));
  }
  return kFailure;
}

}  // namespace glassbox
