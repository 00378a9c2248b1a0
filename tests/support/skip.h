// Skips a test case that cannot run here because data, a program or a device is missing: it is
// counted as skipped, not as passed.
#pragma once

#include <iostream>
#include <sstream>
#include <string>

#include "tests/support/catch.h"

namespace glassbox::test {

// Prints the line that tests/summarise.awk reads: the reason, and the name of the test case that is
// skipped.
inline void say_skipped(const std::string& reason) {
  std::cout << "skipped: " << reason << " -- " << Catch::getResultCapture().getCurrentTestName()
            << std::endl;
}

}  // namespace glassbox::test

// Returns from the test function: SKIP_TEST("no assets under " << folder). It replaces SKIP(),
// which Catch2 before 3.3 does not have. It is for whole test cases: checks before it would not be
// counted. It calls SUCCEED, because a test case without an assertion fails (tests/CMakeLists.txt).
#define SKIP_TEST(reason)                           \
  do {                                              \
    std::ostringstream skip_reason;                 \
    skip_reason << reason;                          \
    glassbox::test::say_skipped(skip_reason.str()); \
    SUCCEED("skipped");                             \
    return;                                         \
  } while (false)
