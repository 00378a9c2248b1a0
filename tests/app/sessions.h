// Runs the sessions in a page of docs/ again: the text below each command must be what the command
// prints.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/working_directory.h"
#include "tests/support/catch.h"

namespace glassbox::test {

struct Session {
  std::string command, output;  // without the "$ " before and the blank lines after it
};

// Returns the sessions of all blocks between ``` in the page. The output of a command ends at the
// next command or at the end of the block.
inline std::vector<Session> sessions_of(std::istream& page) {
  std::vector<Session> sessions;
  bool in_block = false, in_session = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("```")) {
      in_block = !in_block;
      in_session = false;
    } else if (in_block && line.starts_with("$ ")) {
      sessions.push_back({line.substr(2), ""});
      in_session = true;
    } else if (in_session) {
      sessions.back().output += line + "\n";
    }
  }
  return sessions;
}

// Whether the printed text is the page's, in which a line "..." may replace any text.
inline bool matches_session(std::string printed, const std::string& page) {
  const std::string left_out = "...\n";
  std::istringstream lines(page);
  bool anywhere = false;
  std::string part;
  for (std::string line; std::getline(lines, line);) {
    if (line + "\n" != left_out) {
      part += line + "\n";
      continue;
    }
    const std::size_t at = printed.find(part);
    if (at == std::string::npos || (!anywhere && at != 0)) return false;
    printed.erase(0, at + part.size());
    part.clear();
    anywhere = true;
  }
  return anywhere ? printed.ends_with(part) : printed == part;
}

// Runs the sessions of a page: `$ cat FILE` writes the file, and every other command runs glassbox.
// Returns the number of the latter.
inline int replay(const WorkingDirectory& here, const std::string& page) {
  const auto without_last_blanks = [](std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text + "\n";
  };
  std::ifstream in(std::string(GLASSBOX_SOURCE_DIR) + "/" + page);
  REQUIRE(in);
  int count = 0;
  for (const Session& session : sessions_of(in)) {
    const std::string program = "glassbox ", shown = "cat ";
    const std::string output = without_last_blanks(session.output);
    if (session.command.starts_with(shown)) {
      here.write(session.command.substr(shown.size()), output);
      continue;
    }
    CAPTURE(session.command);
    REQUIRE(session.command.starts_with(program));
    const Outcome outcome = here.run(session.command.substr(program.size()));
    CAPTURE(outcome.out, output);
    CHECK(outcome.exit_code == 0);
    CHECK(matches_session(without_last_blanks(outcome.out), output));
    ++count;
  }
  return count;
}

}  // namespace glassbox::test
