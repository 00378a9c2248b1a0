// Tests the annotations for GitHub Actions: one line a picture, whatever its name has in it.
#include "tests/support/catch.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "tests/report/comparisons.h"

#include <glassbox/compare/report/github.h>

namespace glassbox::test {
namespace {

std::vector<std::string> annotations_of(const std::vector<Comparison>& comparisons) {
  std::istringstream text(github_annotations(comparisons));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// What GitHub reads in a property or a message.
std::string decoded(std::string text) {
  for (std::size_t at = 0; (at = text.find('%', at)) != std::string::npos; ++at) {
    text.replace(at, 3, 1, char(std::stoi(text.substr(at + 1, 2), nullptr, 16)));
  }
  return text;
}

TEST_CASE("every picture that does not pass has an annotation at its reference") {
  const std::vector<std::string> lines =
      annotations_of({comparison("a", Verdict::kSame), comparison("b", Verdict::kWithinTolerance),
                      different("c"), without_test("d"), without_reference("e"), broken("f")});
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] ==
        "::error file=ref/c,title=picture different::c: different: 3 of 32 pixels differ");
  CHECK(lines[1].starts_with("::error file=ref/d,title=picture missing::d: missing: "));
  CHECK(lines[2].starts_with("::error file=ref/e,title=picture new::e: new: "));
  CHECK(lines[3].starts_with("::error file=ref/f,title=picture not compared::f: not compared: "));
  CHECK(annotations_of({}).empty());
}

TEST_CASE("the annotation's file and text are those of the picture, for random names") {
  Random random(62);
  for (int round = 0; round < 500; ++round) {
    std::string name;
    for (auto i = random.integer(1, 30); i > 0; --i) {
      name += random.integer(0, 1) == 0 ? ":,%\r\n;= "[random.integer(0, 7)]
                                        : char(random.integer('a', 'z'));
    }
    INFO("seed 62, round " << round);
    Comparison one = different(name);
    one.hints = {"a hint"};
    const std::vector<std::string> lines = annotations_of({one});
    REQUIRE(lines.size() == 1);
    const std::size_t file = lines[0].find("file=") + 5, title = lines[0].find(",title=");
    CHECK(decoded(lines[0].substr(file, title - file)) == one.reference.path);
    CHECK(decoded(lines[0]).ends_with("\n  likely: a hint"));
  }
}

}  // namespace
}  // namespace glassbox::test
