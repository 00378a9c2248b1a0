// A test case that cannot be made here, for want of data, of a program or of a device: it is counted as skipped, not as
// passed.
#pragma once

#include <iostream>
#include <sstream>
#include <string>

#include "tests/support/catch.h"

namespace glassbox::test {

// tests/summarise.awk reads this line: the reason, and the test case that goes without its checks.
inline void say_skipped(const std::string& reason) {
  std::cout << "skipped: " << reason << " -- " << Catch::getResultCapture().getCurrentTestName()
            << std::endl;
}

}  // namespace glassbox::test

// Ends the function, which returns nothing: SKIP_TEST("no assets under " << folder). Catch2 before 3.3 has no SKIP(). It is
// for whole test cases: what has been checked before it would not be counted. SUCCEED, because a test case without an assertion
// fails (tests/CMakeLists.txt).
#define SKIP_TEST(reason)                           \
  do {                                              \
    std::ostringstream skip_reason;                 \
    skip_reason << reason;                          \
    glassbox::test::say_skipped(skip_reason.str()); \
    SUCCEED("skipped");                             \
    return;                                         \
  } while (false)
