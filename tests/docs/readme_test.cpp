// Runs README's command lines, in their order and without changes.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/docs/shell.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// Whether the line is one of the two that build the program and its tests: this test runs inside
// the second one.
bool is_exempt(const std::string& line) {
  const std::string words = line.substr(0, line.find('#'));
  const std::string command = words.substr(0, words.find_last_not_of(' ') + 1);
  return command == "./glassbox" || command == "./glassbox test";
}

// Returns all lines of README's blocks that are marked as shell.
std::vector<std::string> lines_of_readme_and_tour() {
  std::vector<std::string> lines;
  for (const char* page : {"README.md", "docs/tour.md"}) {
    bool in_block = false;
    for (const std::string& line : lines_of(page)) {
      if (line.starts_with("```")) {
        in_block = line == "```sh";
      } else if (in_block && !is_exempt(line)) {
        lines.push_back(line);
      }
    }
  }
  return lines;
}

}  // namespace

TEST_CASE(
    "every command line of README and the tour runs in a fresh clone, and leaves nothing that git "
    "sees") {
  const std::vector<std::string> lines = lines_of_readme_and_tour();
  REQUIRE(lines.size() >= 15);
  const Clone clone;
  const std::vector<std::string> before = clone.files();
  for (const std::string& line : lines) {
    CAPTURE(line);
    const Outcome outcome = clone.run(line);
    CAPTURE(outcome.out, outcome.err);
    CHECK(outcome.exit_code == 0);
  }
  CHECK(clone.files() == before);
}

TEST_CASE("a command line that needs what is not there is found") {
  const Clone clone;
  CHECK(clone.run("./glassbox info examples/house.gltf").exit_code == 0);
  CHECK(clone.run("./glassbox info duck.glb").exit_code == 2);
  CHECK(clone.run("./glassbox render cube --size 16x16").exit_code == 0);
  CHECK(std::ranges::count(clone.files(), "cube.png") == 1);
}

}  // namespace glassbox::test
