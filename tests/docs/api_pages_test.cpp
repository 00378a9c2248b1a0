// Tests what docs/doxygen_filter.awk turns the headers' comments into, and the names on the pages
// of docs/api.md.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/docs/tree.h"
#include "tests/images/temporary_directory.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

namespace glassbox::test {
namespace {

std::string filtered(const std::string& header) {
  const TemporaryDirectory here;
  std::ofstream(here.file("a.h")) << header;
  const std::string filter = (tree() / "docs/doxygen_filter.awk").string();
  const Outcome outcome = run_program("/usr/bin/env", {"awk", "-f", filter, here.file("a.h")}, "/");
  CHECK(outcome.exit_code == 0);
  return outcome.out;
}

// Returns the texts between backquotes in a cell of a table row; cell 1 is the first.
std::vector<std::string> quoted(const std::string& row, int cell) {
  std::istringstream cells(row);
  std::string text;
  for (int i = 0; i <= cell; ++i) std::getline(cells, text, '|');
  std::vector<std::string> all;
  std::istringstream parts(text);
  for (int i = 0; std::getline(parts, text, '`'); ++i) {
    if (i % 2 == 1) all.push_back(text);
  }
  return all;
}

bool has_word(const std::vector<std::string>& headers, const std::string& word) {
  return std::ranges::any_of(headers, [&](const std::string& header) {
    const auto lines = lines_of(header);
    return std::ranges::any_of(lines, [&](const std::string& line) {
      const std::size_t at = line.find(word);
      return !line.starts_with("//") && at != line.npos &&
             (at == 0 || std::string(" *&").find(line[at - 1]) != std::string::npos);
    });
  });
}

}  // namespace

TEST_CASE("the headers that docs/api.md lists have the names that it lists beside them") {
  int names = 0;
  for (const std::string& row : lines_of("docs/api.md")) {
    if (!row.starts_with("| ")) continue;
    for (const std::string& name : quoted(row, 3)) {
      CAPTURE(row, name);
      CHECK(has_word(quoted(row, 2), name));
      ++names;
    }
  }
  CHECK(names > 15);
  CHECK_FALSE(has_word({"mesh/formats/load.h"}, "save_scene"));
}

TEST_CASE("a header's comments become documentation where they are about something") {
  CHECK(filtered("// A file.\n#pragma once\n\n// A type.\nstruct A;\n") ==
        "/// @file\n/// A file.\n#pragma once\n\n/// A type.\nstruct A;\n");
  CHECK(filtered("#pragma once\n// ---- part ----\n\n// Of nothing.\n\nint a;\n") ==
        "#pragma once\n// ---- part ----\n\n// Of nothing.\n\nint a;\n");
}

TEST_CASE("a comment behind a member is about it, and goes on below itself") {
  CHECK(filtered("#pragma once\nint a;   // one\n         // and more\n  // Next.\nint b;\n") ==
        "#pragma once\nint a;   ///< one\n         ///< and more\n  /// Next.\nint b;\n");
  CHECK(filtered("#pragma once\n}  // namespace a\n#endif  // B\n") ==
        "#pragma once\n}  // namespace a\n#endif  // B\n");
}

TEST_CASE(
    "words that Doxygen would take for commands stay words, and indented lines stay as they are") {
  CHECK(filtered("#pragma once\n// A<b> of x_y, `c<d>`:\n//   e  <f>\n// done\nint a;\n") ==
        "#pragma once\n/// A\\<b\\> of x\\_y, `c<d>`:\n/// @verbatim\n///   e  <f>\n"
        "/// @endverbatim\n/// done\nint a;\n");
  CHECK(filtered("#pragma once\n// Two:\n//   - one\n//     of them\nint a;\n") ==
        "#pragma once\n/// Two:\n///   - one\n///     of them\nint a;\n");
}

}  // namespace glassbox::test
