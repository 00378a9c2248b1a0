// Checks of the program's output that the tests of the command line share.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/app/working_directory.h"
#include "tests/support/catch.h"
#include "tests/support/contains.h"

namespace glassbox::test {

// Returns the text as one line, with each run of blanks and line ends replaced by a blank, to find
// sentences that are wrapped.
inline std::string unwrapped(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || !line.ends_with(' ')) line += blank ? ' ' : c;
  }
  return line;
}

// Expects exit code 2, nothing on standard output, and one line on standard error that contains
// these parts.
inline void check_refused(const Outcome& outcome, const std::vector<std::string>& parts) {
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  for (const std::string& part : parts) {
    INFO("expected: " << part);
    CHECK(contains(outcome.err, part));
  }
}

inline std::vector<std::string> sorted_names(const WorkingDirectory& here) {
  std::vector<std::string> names = here.names();
  std::sort(names.begin(), names.end());
  return names;
}

// Runs a line of /bin/sh in the working directory; $0 in it is the program.
inline Outcome in_shell(const WorkingDirectory& here, const std::string& line) {
  return run_program("/bin/sh", {"-c", line, GLASSBOX_PROGRAM}, here.path());
}

}  // namespace glassbox::test
