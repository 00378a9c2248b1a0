// What docs/doxygen_filter.awk makes of the headers' comments for the pages of docs/api.md.
#include <string>

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

}  // namespace

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
