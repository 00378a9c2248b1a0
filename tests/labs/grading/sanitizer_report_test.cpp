// Tests that the sanitizers' error messages, of both compilers, are summed up in one line.
#include "labs/grading/sanitizer_report.h"
#include "tests/support/catch.h"

namespace glassbox::labs::grading {

TEST_CASE("a sanitizer's report is told in one line, whichever compiler's it is") {
  const std::string gcc =
      "=3==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602 at pc 0x55\n"
      "READ of size 8 at 0x602 thread T0\n"
      "    #0 0x55d0 in std::vector<int>::at(int) /usr/include/c++/12/vector:3\n"
      "    #1 0x55d1 in lab_05::f(int, std::vector<int> const&) /tmp/b-1/student.cpp:24\n";
  CHECK(sanitizer_finding(gcc) == "heap-buffer-overflow, student.cpp:24, in lab_05::f");
  const std::string clang =
      "student.cpp:18:13: runtime error: signed integer overflow\n"
      "    #0 0x55d18ed05736 in lab_05::f(std::vector<int> const&) /tmp/b-1/student.cpp:18:13\n"
      "    #1 0x55d18ed083e4 in lab_05::(anonymous namespace)::ask(int) runner.cpp\n";
  CHECK(sanitizer_finding(clang) == "signed integer overflow, student.cpp:18, in lab_05::f");
  CHECK(sanitizer_finding("x: runtime error: a sum\n    #0 0x5 in lab_05::(anonymous namespace)::g"
                          "(int) /b/student.cpp:3:4\n") == "a sum, student.cpp:3, in lab_05::g");
  CHECK(sanitizer_finding("x: runtime error: a sum\n    #0 0x5 in f() not_student.cpp:3:4\n") ==
        "a sum");
  const char* const assertion =
      "/usr/include/c++/12/array:208: double& f(): Assertion '__n < this->size()' failed.\n"
      "==7==ERROR: AddressSanitizer: ABRT on unknown address 0x7 (pc 0x7f4 T0)\n"
      "    #0 0x7f4 in raise raise.c:26\n"
      "    #1 0x55d in lab_05::f(int) student.cpp:18:3\n";
  CHECK(sanitizer_finding(assertion) ==
        "the standard library's assertion '__n < this->size()' failed, student.cpp:18, in "
        "lab_05::f");
  CHECK_FALSE(sanitizer_finding("hello\n"));
}

}  // namespace glassbox::labs::grading
