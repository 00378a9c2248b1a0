#include "labs/grading/process.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>

#include <grp.h>

#include <fmt/format.h>

#include "cli/process/wait_for_process.h"
#include "labs/grading/landlock.h"

namespace glassbox::labs::grading {

namespace {

// Everything that the child needs. It is prepared before the fork, because nothing may be allocated
// after the fork.
struct PreparedChild {
  std::vector<char*> argv, environment;
  const char* directory = nullptr;
  const Launch* launch = nullptr;
  SystemCallFilter filter;
  int input = -1, answers = -1, printed = -1, crash_report = -1, filter_file = -1, errors = -1;
};

bool limit(int what, std::size_t value) {
  const rlimit both{value, value};
  return ::setrlimit(static_cast<__rlimit_resource_t>(what), &both) == 0;
}

bool set_limits(const Limits& limits, bool own_user) {
  bool fine = limit(RLIMIT_CORE, 0) && limit(RLIMIT_NOFILE, 64);
  fine = fine && limit(RLIMIT_CPU, static_cast<std::size_t>(std::ceil(limits.seconds)) + 1);
  fine = fine && limit(RLIMIT_FSIZE, limits.file_bytes) && limit(RLIMIT_STACK, limits.stack_bytes);
  // This limit counts all processes of a user, not only those of this process.
  if (own_user) fine = fine && limit(RLIMIT_NPROC, limits.processes);
  return fine && (limits.memory_bytes == 0 || limit(RLIMIT_AS, limits.memory_bytes));
}

[[noreturn]] void report_error_and_exit(const PreparedChild& prepared, const char* step) {
  const int error = errno;
  [[maybe_unused]] auto written = ::write(prepared.errors, &error, sizeof error);
  written = ::write(prepared.errors, step, std::strlen(step));
  ::_exit(127);
}

bool switch_user(uid_t user) {
  return ::setgroups(0, nullptr) == 0 && ::setresgid(user, user, user) == 0 &&
         ::setresuid(user, user, user) == 0;
}

[[noreturn]] void run_child(PreparedChild& prepared, pid_t parent) {
  const Launch& launch = *prepared.launch;
  ::setsid();
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) ::signal(signal, SIG_DFL);
  const std::array<std::array<int, 2>, 6> places{{{prepared.input, 0},
                                                  {prepared.printed, 1},
                                                  {prepared.printed, 2},
                                                  {prepared.answers, kAnswersFd},
                                                  {prepared.crash_report, kCrashReportFd},
                                                  {prepared.filter_file, kFilterFd}}};
  for (const auto& [from, to] : places) {
    if (from < 0) continue;
    if (::dup2(from, to) < 0) report_error_and_exit(prepared, "connecting its files");
  }
  const unsigned first_closed = prepared.filter_file >= 0 ? kFilterFd + 1 : kCrashReportFd + 1;
#ifdef SYS_close_range
  constexpr unsigned kOnExec = 1U << 2;  // CLOSE_RANGE_CLOEXEC
  ::syscall(SYS_close_range, first_closed, ~0U, kOnExec);
#endif
  if (::chdir(prepared.directory) != 0) report_error_and_exit(prepared, "entering its directory");
  if (!set_limits(launch.limits, launch.user.has_value()))
    report_error_and_exit(prepared, "setting its limits");
  if (launch.user && !switch_user(*launch.user))
    report_error_and_exit(prepared, "changing to its user");
  // The child is to be killed when its parent ends. This is set after the change of user, which
  // would clear it.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
    report_error_and_exit(prepared, "giving up new privileges");
  if (launch.file_rules >= 0 && !apply_file_rules(launch.file_rules))
    report_error_and_exit(prepared, "setting its rules for files");
  if (!launch.in_bubblewrap && !prepared.filter.empty()) {
    set_own_pid(prepared.filter, static_cast<unsigned>(::getpid()));
    const sock_fprog program{static_cast<unsigned short>(prepared.filter.size()),
                             prepared.filter.data()};
    if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
      report_error_and_exit(prepared, "setting its system-call filter");
  }
  ::execve(prepared.argv[0], prepared.argv.data(), prepared.environment.data());
  report_error_and_exit(prepared, "running the program");
}

RunOutcome not_started(std::string why) {
  RunOutcome outcome;
  outcome.ending = RunOutcome::Ending::kNotStarted;
  outcome.detail = std::move(why);
  return outcome;
}

// Determines how the process ended, from its status and from the crash report that it left.
void classify(RunOutcome& outcome, int status, const std::string& crash_report,
              bool in_bubblewrap) {
  using Ending = RunOutcome::Ending;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  // Bubblewrap exits with 128 + the signal that ended the process inside.
  int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (in_bubblewrap && code > 128 && code <= 128 + 64) signal = code - 128;
  outcome.ending = signal != 0 ? Ending::kSignal : Ending::kExit;
  outcome.code = signal != 0 ? signal : code;
  if (signal == SIGXCPU) outcome.ending = Ending::kTimeout;
  if (signal == SIGXFSZ) {
    outcome.ending = Ending::kTooMuchOutput;
    outcome.detail = "the program wrote a larger file than is allowed";
  }
  if (signal == SIGSYS) {
    outcome.ending = Ending::kForbidden;
    if (crash_report.starts_with("call "))
      outcome.detail = system_call_name(std::atoi(crash_report.c_str() + 5));
  }
  if (signal == SIGSEGV && crash_report.starts_with("stack")) outcome.detail = "stack overflow";
  if (crash_report.starts_with("memory") && (signal != 0 || code != 0))
    outcome.ending = Ending::kOutOfMemory;
}

}  // namespace

RunOutcome launch(const Launch& launch) {
  Pipe answers, printed, crash_report, errors;
  if (!answers.valid() || !printed.valid() || !crash_report.valid() || !errors.valid())
    return not_started("the system cannot make a pipe");
  PreparedChild prepared;
  prepared.launch = &launch;
  prepared.directory = launch.directory.c_str();
  for (const std::string& word : launch.command)
    prepared.argv.push_back(const_cast<char*>(word.c_str()));
  for (const std::string& word : launch.environment)
    prepared.environment.push_back(const_cast<char*>(word.c_str()));
  prepared.argv.push_back(nullptr);
  prepared.environment.push_back(nullptr);
  prepared.filter = launch.filter;
  const Descriptor empty_input(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  Descriptor filter_file;
  if (launch.in_bubblewrap && !launch.filter.empty()) {
    const int file = ::memfd_create("filter", MFD_CLOEXEC);
    const std::size_t bytes = launch.filter.size() * sizeof(sock_filter);
    if (file < 0 || ::pwrite(file, launch.filter.data(), bytes, 0) != static_cast<ssize_t>(bytes))
      return not_started("no file in memory can be made for the system-call filter");
    filter_file.set(file);
  }
  prepared.input = launch.input >= 0 ? launch.input : empty_input.get();
  prepared.answers = answers.write.get();
  prepared.printed = printed.write.get();
  prepared.crash_report = crash_report.write.get();
  prepared.errors = errors.write.get();
  prepared.filter_file = filter_file.get();

  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) return not_started(fmt::format("fork: {}", std::strerror(errno)));
  if (process == 0) run_child(prepared, parent);
  for (Pipe* pipe : {&answers, &printed, &crash_report, &errors}) pipe->write.close();

  const Limits& limits = launch.limits;
  std::array<Stream, 3> streams{Stream{&answers, limits.output_bytes, limits.output_bytes},
                                Stream{&printed, limits.kept_bytes, limits.printed_bytes},
                                Stream{&crash_report, 64, 4096}};
  const WaitResult result = wait_for_process(process, streams, limits.seconds);

  RunOutcome outcome;
  outcome.seconds = result.seconds;
  char why[128];
  const ssize_t length = ::read(errors.read.get(), why, sizeof why);
  if (length > static_cast<ssize_t>(sizeof(int))) {
    int error = 0;
    std::memcpy(&error, why, sizeof error);
    const std::string step(why + sizeof error, static_cast<std::size_t>(length) - sizeof error);
    return not_started(
        fmt::format("{}: {} failed: {}", launch.command[0], step, std::strerror(error)));
  }
  outcome.answers = std::move(streams[0].text);
  outcome.printed = std::move(streams[1].text);
  const bool too_much =
      streams[0].exceeds_limit() || streams[1].exceeds_limit() || streams[2].exceeds_limit();
  if (too_much) {
    outcome.ending = RunOutcome::Ending::kTooMuchOutput;
    if (streams[1].exceeds_limit())
      outcome.detail =
          fmt::format("the program printed more than {} MiB", limits.printed_bytes / kMiB);
  } else if (!result.ended) {
    outcome.ending = RunOutcome::Ending::kTimeout;
  } else {
    classify(outcome, result.status, streams[2].text, launch.in_bubblewrap);
  }
  return outcome;
}

}  // namespace glassbox::labs::grading
