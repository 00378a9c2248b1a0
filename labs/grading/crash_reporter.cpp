// Linked into every runner that is graded. It writes to descriptor 4 why the process is about to
// end, where the signal alone would not tell. A student's code can change or silence it, but gains
// nothing by that.
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace {

constexpr int kCrashReportFd = 4;
constexpr std::size_t kMiB = std::size_t(1) << 20;

std::uintptr_t stack_top = 0;
std::size_t stack_bytes = 0;
char stack_of_handlers[16384];

void report_crash(const char* text) {
  [[maybe_unused]] const auto written = ::write(kCrashReportFd, text, std::strlen(text));
}

void end_by(int signal) {
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

void on_forbidden_call(int signal, siginfo_t* info, void*) {
  char text[32] = "call ";
  std::size_t length = 5;
  char digits[12];
  int count = 0;
  for (int rest = info->si_syscall; count == 0 || rest > 0; rest /= 10)
    digits[count++] = static_cast<char>('0' + rest % 10);
  while (count > 0) text[length++] = digits[--count];
  text[length] = '\0';
  report_crash(text);
  end_by(signal);
}

void on_bad_address(int signal, siginfo_t* info, void*) {
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  // The stack has overflowed: the address is near the stack's end, or at most 8 MiB below it, where
  // the local variables of a large function may be.
  if (address < stack_top - stack_bytes + kMiB / 4 &&
      address + stack_bytes + 8 * kMiB > stack_top) {
    report_crash("stack");
  } else {
    // Perhaps the memory is used up: at the limit malloc returns null, and many programs then write
    // to null. In that case no further memory can be had either.
    void* more = ::mmap(nullptr, 16 * kMiB, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (more == MAP_FAILED) report_crash("memory");
  }
  end_by(signal);
}

void on_no_memory() {
  report_crash("memory");
  ::_exit(1);
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action = {};
  action.sa_sigaction = handler;
  action.sa_flags = int(SA_SIGINFO | SA_ONSTACK | SA_RESETHAND);
  ::sigaction(signal, &action, nullptr);
}

// Runs before any constructor of the student's code.
[[gnu::constructor(101)]] void install_handlers() {
  int local = 0;
  stack_top = reinterpret_cast<std::uintptr_t>(&local);
  rlimit limit{};
  if (::getrlimit(RLIMIT_STACK, &limit) == 0) stack_bytes = limit.rlim_cur;
  stack_t handlers{};
  handlers.ss_sp = stack_of_handlers;
  handlers.ss_size = sizeof stack_of_handlers;
  ::sigaltstack(&handlers, nullptr);
  handle(SIGSYS, on_forbidden_call);
  handle(SIGSEGV, on_bad_address);
  std::set_new_handler(on_no_memory);
}

}  // namespace
