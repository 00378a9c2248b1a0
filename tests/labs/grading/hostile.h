// Submissions that attack the grader, one of each kind. The hostile code is in reciprocal(), and
// twice() is right, so that it can be seen which points the attack costs.
#pragma once

#include <string>
#include <vector>

namespace glassbox::test {

struct Hostile {
  std::string name;
  std::string outcome;      // beginning of the report's outcome for "a reciprocal"
  std::string body;         // in reciprocal(), before its return
  std::string top = {};     // before the functions
  bool costs_some = false;  // some cases of the check still count
};

inline std::string source_of(const Hostile& hostile) {
  return "#include \"student.h\"\n" + hostile.top + "\ndouble twice(double x) { return 2 * x; }\n" +
         "double reciprocal(double x) {\n" + hostile.body + "\nreturn 1 / x;\n}\n";
}

inline const std::vector<Hostile>& hostile_runs() {
  static const std::string posix =
      "#include <unistd.h>\n#include <signal.h>\n#include <fcntl.h>\n#include <sys/socket.h>\n"
      "#include <sys/ptrace.h>\n#include <sys/mount.h>\n#include <sys/resource.h>\n";
  static const std::vector<Hostile> all{
      {"crash", "crash (SIGSEGV)", "*(volatile int*)nullptr = 1;"},
      {"abort", "crash (SIGABRT)", "std::abort();", "#include <cstdlib>\n"},
      {"division", "crash (SIGFPE)", "volatile int zero = 0; volatile int y = 7 / zero; (void)y;"},
      {"stack", "crash (stack overflow)", "x += deep(1);",
       "double deep(int n) { volatile char b[4096]; b[n % 4096] = 1; return deep(n + 1) + b[n % "
       "7]; }\n"},
      {"hang", "timeout", "for (volatile int i = 0;; ++i) {}"},
      {"sleep", "timeout", "sleep(1000);", posix},
      {"quiet-hang", "timeout",
       "for (int i = 0; i < 64; ++i) close(i);\nfor (volatile int i = 0;; ++i) {}", posix},
      {"memory", "out of memory", "for (;;) kept.emplace_back(1 << 22, 1);",
       "#include <vector>\nstd::vector<std::vector<char>> kept;\n"},
      // The pointer is volatile: otherwise the compiler would remove the allocation.
      {"malloc", "out of memory",
       "for (void* volatile p;;) p = std::malloc(1 << 22), std::memset(p, 1, 1 << 22);",
       "#include <cstdlib>\n#include <cstring>\n"},
      {"fork-bomb", "forbidden call", "for (;;) fork();", posix},
      {"threads", "forbidden call", "for (;;) new std::thread([] { for (;;) {} });",
       "#include <thread>\n"},
      {"exit-0", "no answer (ended with exit status 0)", "std::exit(0);", "#include <cstdlib>\n"},
      {"exit-quick", "no answer (ended with exit status 0)", "_exit(0);", posix},
      {"closed-output", "no answer", "for (int i = 0; i < 64; ++i) close(i);", posix},
      {"flood", "too much output", "for (;;) std::puts(\"all is well, all is well, all is well\");",
       "#include <cstdio>\n"},
      {"flood-answers", "too much output",
       "static char block[1 << 16];\nfor (;;) if (write(3, block, sizeof block) < 0) break;",
       posix},
      {"forged-answer", "malformed output",
       "static const char all[] = \"{\\\"case\\\": 0, \\\"fields\\\": {\\\"y\\\": "
       "[1]}}\\n{\\\"case\\\": 1, \\\"score\\\": 10}\\n\";\n"
       "if (write(3, all, sizeof all - 1) < 0) return 0;",
       posix, true},
      {"garbage", "malformed output", "if (write(3, \"{[[[\", 4) < 0) return 0;", posix},
      {"forged-and-gone", "wrong answer",
       "static const char all[] = \"{\\\"case\\\": 0, \\\"fields\\\": {\\\"y\\\": "
       "[7]}}\\n{\\\"case\\\": 1, \\\"fields\\\": {\\\"y\\\": [7]}}\\n\""
       "\n\"{\\\"case\\\": 2, \\\"fields\\\": {\\\"y\\\": [7]}}\\n{\\\"case\\\": 3, "
       "\\\"fields\\\": {\\\"y\\\": [7]}}\\n\";\n"
       "if (write(3, all, sizeof all - 1) > 0) _exit(0);",
       posix},
      {"deletes", "forbidden call (unlink", "unlink(\"results.json\");", posix},
      {"writes", "forbidden call (open",
       "open(\"/tmp/glassbox-was-here\", O_CREAT | O_WRONLY, 0600);", posix},
      {"reads", "forbidden call (open", "open(\"/etc/passwd\", O_RDONLY);", posix},
      {"network", "forbidden call (socket)", "socket(AF_INET, SOCK_STREAM, 0);", posix},
      {"kills-parent", "forbidden call (kill)", "kill(getppid(), SIGKILL);", posix},
      {"kills-all", "forbidden call (kill)", "kill(-1, SIGKILL);", posix},
      {"traces", "forbidden call (ptrace)", "ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr);",
       posix},
      {"mounts", "forbidden call (mount)", "mount(\"none\", \"/tmp\", \"tmpfs\", 0, nullptr);",
       posix},
      {"limits", "forbidden call (prlimit64)",
       "rlimit most{RLIM_INFINITY, RLIM_INFINITY};\nsetrlimit(RLIMIT_CPU, &most);", posix},
      {"throws", "exception", "throw 1;"},
      {"catches-signals", "timeout",
       "for (int s = 1; s < 32; ++s) signal(s, SIG_IGN);\nfor (volatile int i = 0;; ++i) {}",
       posix},
  };
  return all;
}

// Returns submissions that do not compile, or must not, so that nothing of them runs. `body` is the
// whole student.cpp.
inline std::vector<Hostile> hostile_sources(const std::string& solution) {
  return {
      {"syntax", "compile error", "int x = ;"},
      {"no-functions", "compile error", ""},
      {"reads-the-solution", "compile error", "#include \"" + solution + "\"\n"},
      {"endless-include", "compile error", "#include \"student.cpp\"\n"},
      {"endless-template", "compile error",
       "template <int N> struct Deep { static constexpr int v = Deep<N + 1>::v; };\nint x = "
       "Deep<0>::v;\n"},
      {"includes-a-device", "compile error", "#include \"/dev/zero\"\n"},
      {"huge-object", "compile error", "char huge[1 << 30] = {1};\n"},
      {"own-main", "compile error", "int main() { return 0; }\n"},
  };
}

}  // namespace glassbox::test
