// Tests the summary at the end of ./glassbox test: tests/summarise.awk, and what it relies on.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/images/temporary_directory.h"
#include "tests/support/run_program.h"
#include "tests/support/skip.h"

namespace glassbox::test {

namespace {

namespace fs = std::filesystem;

// Returns the lines that ctest logs for one test.
std::string logged(const std::string& name, const std::string& output,
                   const std::string& end = "Test Passed.") {
  return "1/9 Testing: " + name + "\n1/9 Test: " + name + "\nCommand: \"/a/test_" + name +
         "\"\nOutput:\n----\n" + output + "<end of output>\nTest time =   0.01 sec\n----\n" + end +
         "\n\"" + name + "\" end time: Jan 01 00:00 UTC\n----\n\n";
}

std::string summary_of(const std::string& log) {
  const TemporaryDirectory here;
  std::ofstream(here.file("log")) << log;
  const Outcome outcome =
      run_program("/usr/bin/env",
                  {"awk", "-f", GLASSBOX_SOURCE_DIR "/tests/summarise.awk", here.file("log")}, "/");
  REQUIRE(outcome.exit_code == 0);
  return outcome.out;
}

const std::string kThree = "All tests passed (12 assertions in 3 test cases)\n";

}  // namespace

TEST_CASE("a suite counts as its test cases, and what is no suite as one") {
  CHECK(summary_of(logged("a", kThree) + logged("b", "fine\n")) == "4 0 0\n");
  CHECK(summary_of(logged("a", "All tests passed (1 assertion in 1 test case)\n")) == "1 0 0\n");
  CHECK(summary_of(logged("a", "test cases: 5 | 3 passed | 2 failed\n", "Test Failed.")) ==
        "3 2 0\nfailed: a\n");
}

TEST_CASE("a test that passes by what it prints counts as passed") {
  CHECK(summary_of(logged("a", "said\n",
                          "Test Pass Reason:\nRequired regular expression found.")) == "1 0 0\n");
  CHECK(summary_of(logged("a", "said\n", "Test Fail Reason:\nError regular expression found.")) ==
        "0 1 0\nfailed: a\n");
}

TEST_CASE("what fails is never counted as passed") {
  CHECK(summary_of(logged("a", "no summary\n", "Test Failed.")) == "0 1 0\nfailed: a\n");
  CHECK(summary_of(logged("a", kThree, "Test Failed.") + logged("b", kThree)) ==
        "6 1 0\nfailed: a\n");
  CHECK(summary_of("1/9 Test: a\nCommand: \"\"\nTest Passed.\n") ==
        "0 1 0\nfailed: a (its program was not built)\n");
}

TEST_CASE("skipped tests are counted as skipped and not as passed, each reason once") {
  CHECK(summary_of(
            logged("a", "skipped: no meshes -- first\nskipped: no meshes -- second\n" + kThree) +
            logged("b", "skipped: no gdb\n") + logged("c", kThree)) ==
        "4 0 3\nskipped: no meshes (2 tests)\nskipped: no gdb (1 test)\n");
  // A test case with two sections that is skipped twice counts once; then all test cases of a suite
  // are skipped.
  CHECK(summary_of(logged("a", "skipped: x -- a\nskipped: x -- a\n" + kThree)) ==
        "2 0 1\nskipped: x (1 test)\n");
  CHECK(summary_of(logged("a", "skipped: x -- a\nskipped: x -- b\nskipped: y -- c\n" + kThree)) ==
        "0 0 3\nskipped: x (2 tests)\nskipped: y (1 test)\n");
  CHECK(summary_of(logged("a", "skipped: x -- a\ntest cases: 5 | 4 passed | 1 failed\n",
                          "Test Failed.")) == "3 1 1\nfailed: a\nskipped: x (1 test)\n");
}

TEST_CASE("a test case that is left out says so in the words that are counted", "[.skipped]") {
  SKIP_TEST("it is " << 1 << " example");
  FAIL("nothing after it is done");
}

TEST_CASE("a test case that is left out is counted as skipped") {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  const Outcome outcome = run_program(self.string(), {"[.skipped]"}, "/");
  CHECK(outcome.exit_code == 0);
  CHECK(summary_of(logged("a", outcome.out)) == "0 0 1\nskipped: it is 1 example (1 test)\n");
}

TEST_CASE("no test says that it is skipped in words of its own") {
  int read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(GLASSBOX_SOURCE_DIR "/tests")) {
    const std::string name = entry.path().lexically_relative(GLASSBOX_SOURCE_DIR).generic_string();
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".h") continue;
    if (name == "tests/support/skip.h" || name.starts_with("tests/suite/")) continue;
    INFO(name);
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    CHECK(text.str().find("\"skipped") == std::string::npos);
    ++read;
  }
  CHECK(read > 100);
}

}  // namespace glassbox::test
