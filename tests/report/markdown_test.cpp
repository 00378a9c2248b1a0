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

TEST_CASE("a summary fits into a comment on GitHub, and counts the pictures without a row") {
  const std::string names[] = {"c", std::string(400, '&'), std::string(400, '$')};
  for (const std::string& name : names) {
    INFO(name.substr(0, 1));
    const std::size_t number = 3000;
    const std::string markdown =
        markdown_report(name, std::vector<Comparison>(number, different(name)));
    CHECK(markdown.size() <= 65'536);
    CHECK(markdown.size() > 50'000);
    const std::size_t rows = rows_of(markdown).size() - 1;
    CHECK(markdown.ends_with("\nand " + std::to_string(number - rows) +
                             " more pictures that do not pass\n"));
  }
  const std::vector<Comparison> few(500, different("c"));
  CHECK(rows_of(markdown_report("t", few)).size() == 501);
}

TEST_CASE("every column of the table has a heading") {
  const std::vector<std::string> rows =
      rows_of(markdown_report("t", std::vector<Comparison>{different("c")}));
  CHECK(rows.at(0) == "| picture | verdict | pixels that differ | why |");
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
    // Behind a backslash, no character has a meaning but the dollar sign, which has none in a span.
    const std::string span = "<span>$</span>";
    std::string row = rows[1];
    for (std::size_t at; (at = row.find(span)) != std::string::npos;) row.erase(at, span.size());
    CHECK(row.find('$') == std::string::npos);
    std::string active;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == '\\') {
        ++i;
      } else {
        active += row[i];
      }
    }
    CHECK(std::count(active.begin(), active.end(), '|') == 5);
    CHECK(active.find_first_of("<>`*_[]") == std::string::npos);
  }
}

}  // namespace
}  // namespace glassbox::test
