// What the tests of the command line ask of its words.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/app/run.h"
#include "tests/support/catch.h"

namespace glassbox::test {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The text as one line, each run of blanks and ends of lines a blank: for sentences that are wrapped.
inline std::string unwrapped(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || !line.ends_with(' ')) line += blank ? ' ' : c;
  }
  return line;
}

// Exit code 2 and one line on standard error alone, with these parts.
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

inline std::vector<std::string> sorted_names(const Workplace& here) {
  std::vector<std::string> names = here.names();
  std::sort(names.begin(), names.end());
  return names;
}

// A line of /bin/sh in the workplace, in which $0 is the program.
inline Outcome in_shell(const Workplace& here, const std::string& line) {
  return run_program("/bin/sh", {"-c", line, GLASSBOX_PROGRAM}, here.path());
}

}  // namespace glassbox::test
