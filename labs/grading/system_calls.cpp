#include "labs/grading/system_calls.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>

#ifdef GLASSBOX_HAS_SECCOMP
#include <seccomp.h>
#endif

namespace glassbox::labs::grading {

#ifdef GLASSBOX_HAS_SECCOMP

namespace {

// The system calls that a statically linked C++ program needs in order to start, compute, allocate,
// print and end.
constexpr const char* kRunnerMay[] = {"read",
                                      "write",
                                      "writev",
                                      "close",
                                      "lseek",
                                      "fstat",
                                      "newfstatat",
                                      "dup",
                                      "dup2",
                                      "dup3",
                                      "brk",
                                      "mmap",
                                      "munmap",
                                      "mprotect",
                                      "mremap",
                                      "madvise",
                                      "rt_sigaction",
                                      "rt_sigprocmask",
                                      "rt_sigreturn",
                                      "sigaltstack",
                                      "restart_syscall",
                                      "exit",
                                      "exit_group",
                                      "execve",
                                      "getpid",
                                      "gettid",
                                      "getppid",
                                      "getuid",
                                      "geteuid",
                                      "getgid",
                                      "getegid",
                                      "clock_gettime",
                                      "clock_getres",
                                      "gettimeofday",
                                      "time",
                                      "times",
                                      "getrusage",
                                      "getrlimit",
                                      "nanosleep",
                                      "clock_nanosleep",
                                      "sched_yield",
                                      "sched_getaffinity",
                                      "getrandom",
                                      "futex",
                                      "arch_prctl",
                                      "set_tid_address",
                                      "set_robust_list",
                                      "rseq",
                                      "uname",
                                      "sysinfo"};

constexpr const char* kCompilerMayNot[] = {"socket",
                                           "socketpair",
                                           "connect",
                                           "bind",
                                           "listen",
                                           "accept",
                                           "accept4",
                                           "ptrace",
                                           "process_vm_readv",
                                           "process_vm_writev",
                                           "pidfd_getfd",
                                           "kcmp",
                                           "mount",
                                           "umount2",
                                           "pivot_root",
                                           "chroot",
                                           "move_mount",
                                           "open_tree",
                                           "fsopen",
                                           "fsmount",
                                           "mount_setattr",
                                           "unshare",
                                           "setns",
                                           "setuid",
                                           "setgid",
                                           "setreuid",
                                           "setregid",
                                           "setresuid",
                                           "setresgid",
                                           "setgroups",
                                           "capset",
                                           "keyctl",
                                           "add_key",
                                           "request_key",
                                           "bpf",
                                           "perf_event_open",
                                           "userfaultfd",
                                           "io_uring_setup",
                                           "init_module",
                                           "finit_module",
                                           "delete_module",
                                           "kexec_load",
                                           "kexec_file_load",
                                           "reboot",
                                           "swapon",
                                           "swapoff",
                                           "sethostname",
                                           "settimeofday",
                                           "clock_settime",
                                           "adjtimex",
                                           "quotactl",
                                           "acct"};

struct Release {
  void operator()(void* context) const { seccomp_release(context); }
};
using Context = std::unique_ptr<void, Release>;

auto filter_error(const std::string& what) {
  return fail("the system-call filter", what, "grade on Linux on x86-64 or AArch64");
}

// Adds a rule. A call that this processor does not have is ignored.
template <class... Conditions>
bool add(const Context& context, std::uint32_t action, const char* name, Conditions... conditions) {
  const int number = seccomp_syscall_resolve_name(name);
  if (number < 0) return true;
  return seccomp_rule_add(context.get(), action, number, sizeof...(conditions), conditions...) == 0;
}

// The condition that an argument of a system call (counted from 0) has this value; libseccomp's own
// macros for it work in C but not in C++.
scmp_arg_cmp equals(unsigned argument, scmp_datum_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}

Result<SystemCallFilter> export_filter(const Context& context) {
  const int file = ::memfd_create("filter", MFD_CLOEXEC);
  if (file < 0) return filter_error("no file in memory can be made for it");
  SystemCallFilter filter;
  if (seccomp_export_bpf(context.get(), file) == 0) {
    const off_t bytes = ::lseek(file, 0, SEEK_END);
    filter.resize(static_cast<std::size_t>(bytes) / sizeof(sock_filter));
    if (::pread(file, filter.data(), static_cast<std::size_t>(bytes), 0) != bytes) filter.clear();
  }
  ::close(file);
  if (filter.empty()) return filter_error("libseccomp cannot write its program");
  return filter;
}

}  // namespace

bool can_filter_system_calls() {
  return true;
}

Result<SystemCallFilter> runner_filter(bool in_namespace) {
  const Context context(seccomp_init(SCMP_ACT_TRAP));
  if (!context) return filter_error("libseccomp cannot make an empty filter");
  bool fine = true;
  for (const char* name : kRunnerMay) fine = add(context, SCMP_ACT_ALLOW, name) && fine;
  // A process may send itself signals (tgkill), as abort() and assert() do.
  if (in_namespace) {
    fine = add(context, SCMP_ACT_ALLOW, "tgkill") && fine;
    // Bubblewrap, the first process in the namespace, is under the filter too and waits for the
    // second process, the student's.
    fine = add(context, SCMP_ACT_ALLOW, "wait4") && fine;
  } else {
    fine = add(context, SCMP_ACT_ALLOW, "tgkill", equals(0, kOwnPid)) && fine;
  }
  // Limits may be queried, but not changed.
  fine = add(context, SCMP_ACT_ALLOW, "prlimit64", equals(2, 0)) && fine;
  for (const scmp_datum_t what : {scmp_datum_t{F_GETFD}, scmp_datum_t{F_GETFL}})
    fine = add(context, SCMP_ACT_ALLOW, "fcntl", equals(1, what)) && fine;
  // glibc queries whether an output is a terminal, and the path of a static program. The calls fail
  // with an error, which glibc accepts, and do not end the process.
  fine = add(context, SCMP_ACT_ERRNO(ENOTTY), "ioctl") && fine;
  fine = add(context, SCMP_ACT_ERRNO(ENOENT), "readlink") && fine;
  fine = add(context, SCMP_ACT_ERRNO(ENOENT), "readlinkat") && fine;
  if (!fine) return filter_error("libseccomp refuses one of its rules");
  return export_filter(context);
}

Result<SystemCallFilter> compiler_filter() {
  const Context context(seccomp_init(SCMP_ACT_ALLOW));
  if (!context) return filter_error("libseccomp cannot make an empty filter");
  bool fine = true;
  for (const char* name : kCompilerMayNot) fine = add(context, SCMP_ACT_ERRNO(EPERM), name) && fine;
  if (!fine) return filter_error("libseccomp refuses one of its rules");
  return export_filter(context);
}

std::string system_call_name(int number) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number), &std::free);
  return name ? std::string(name.get()) : fmt::format("system call {}", number);
}

#else

bool can_filter_system_calls() {
  return false;
}

namespace {
Result<SystemCallFilter> no_seccomp_error() {
  return fail("the system-call filter", "glassbox was built without libseccomp",
              "install libseccomp-dev and build again");
}
}  // namespace

Result<SystemCallFilter> runner_filter(bool) {
  return no_seccomp_error();
}
Result<SystemCallFilter> compiler_filter() {
  return no_seccomp_error();
}
std::string system_call_name(int number) {
  return fmt::format("system call {}", number);
}

#endif

void set_own_pid(SystemCallFilter& filter, unsigned pid) {
  for (sock_filter& instruction : filter) {
    if (BPF_CLASS(instruction.code) == BPF_JMP && instruction.k == kOwnPid) instruction.k = pid;
  }
}

}  // namespace glassbox::labs::grading
