// Tests the summary in Markdown: a row for each picture that does not pass, and nothing that a name
// could change in the page.
#include "tests/support/catch.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/random.h>

#include "tests/report/comparisons.h"

#include <glassbox/compare/report/markdown.h>

namespace glassbox::test {
namespace {

std::vector<std::string> rows_of(const std::string& markdown) {
  std::istringstream text(markdown);
  std::vector<std::string> rows;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("| ") && !line.starts_with("| ---")) rows.push_back(line);
  }
  return rows;
}

TEST_CASE("the summary has the numbers, and a row for each picture that does not pass") {
  const std::string markdown = markdown_report(
      "golden and out", std::vector<Comparison>{comparison("a.png", Verdict::kSame), different("c"),
                                                without_test("d"), broken("f")});
  CHECK(markdown.starts_with("### golden and out\n\n4 pictures: 1 same, 1 different, 1 missing, "));
  const std::vector<std::string> rows = rows_of(markdown);
  REQUIRE(rows.size() == 4);
  CHECK(rows[1] == "| c | different | 3 of 32 | 3 of 32 pixels differ |");
  CHECK(rows[2].starts_with("| d | missing |  | out/d: there is no such picture"));
}

TEST_CASE("where all pictures pass there is no table") {
  const std::string markdown =
      markdown_report("t", std::vector<Comparison>{comparison("a", Verdict::kSame)});
  CHECK(markdown == "### t\n\n1 picture: 1 same\n");
}

TEST_CASE("a thousand pictures are 200 rows, and the number of the others") {
  const std::vector<Comparison> many(1000, different("c"));
  const std::string markdown = markdown_report("t", many);
  CHECK(rows_of(markdown).size() == 201);
  CHECK(markdown.ends_with("\nand 800 more pictures that do not pass\n"));
}

TEST_CASE("random names stay in their cell and mean nothing in Markdown") {
  Random random(63);
  for (int round = 0; round < 500; ++round) {
    std::string name;
    for (auto i = random.integer(1, 30); i > 0; --i) name += char(random.integer(1, 127));
    INFO("seed 63, round " << round);
    const std::vector<std::string> rows =
        rows_of(markdown_report(name, std::vector<Comparison>{different(name)}));
    REQUIRE(rows.size() == 2);
    // Behind a backslash, no character has a meaning.
    std::string active;
    for (std::size_t i = 0; i < rows[1].size(); ++i) {
      if (rows[1][i] == '\\') {
        ++i;
      } else {
        active += rows[1][i];
      }
    }
    CHECK(std::count(active.begin(), active.end(), '|') == 5);
    CHECK(active.find_first_of("<>`*_[]") == std::string::npos);
  }
}

}  // namespace
}  // namespace glassbox::test
