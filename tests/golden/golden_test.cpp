// The golden images: every line of images/golden/commands.txt, run as it stands, gives the picture beside it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/images/temporary_directory.h"
#include "tests/support/run_program.h"

#include <glassbox/compare/testing/catch2.h>
#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>

namespace glassbox::test {
namespace {

const std::string kGolden = std::string(GLASSBOX_SOURCE_DIR) + "/images/golden/";

struct Line {
  std::string file;
  std::vector<std::string> arguments;
};

std::vector<Line> read_commands() {
  std::vector<Line> lines;
  std::ifstream in(kGolden + "commands.txt");
  for (std::string text; std::getline(in, text);) {
    if (text.empty() || text.front() == '#') continue;
    std::istringstream words(text);
    Line line;
    words >> line.file;
    for (std::string word; words >> word;) line.arguments.push_back(word);
    lines.push_back(line);
  }
  return lines;
}

// Runs the line's command with more arguments; what went wrong, or "".
std::string make(const Line& line, const std::vector<std::string>& more,
                 const std::string& picture) {
  std::vector<std::string> arguments = line.arguments;
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.insert(arguments.end(), {"-o", picture});
  const Outcome outcome = run_program(GLASSBOX_PROGRAM, arguments, kGolden);
  const int expected = line.arguments.front() == "diff" ? 1 : 0;  // what it shows is a difference
  if (outcome.exit_code == expected) return "";
  return "exit code " + std::to_string(outcome.exit_code) + ": " + outcome.err;
}

void check_all(const std::vector<Line>& lines, const std::vector<std::string>& more) {
  const TemporaryDirectory directory;
  for (const Line& line : lines) {
    const std::string picture = directory.file(line.file);
    INFO("images/golden/" << line.file);
    REQUIRE(make(line, more, picture) == "");
    CHECK_THAT(PictureFile{picture}, MatchesGolden(kGolden + line.file));
  }
}

TEST_CASE("the golden commands give the golden images, byte for byte") {
  const std::vector<Line> lines = read_commands();
  REQUIRE(lines.size() >= 50);
  check_all(lines, {});
}

TEST_CASE("so does the staged reference, and the tile engine on plain scalars without a plan") {
  std::vector<Line> renders = read_commands();
  std::erase_if(renders, [](const Line& line) { return line.arguments.front() != "render"; });
  REQUIRE(renders.size() >= 50);
  check_all(renders, {"--engine", "staged"});
  check_all(renders, {"--engine", "tile", "--target", "scalar", "--threads", "2", "--no-plan"});
}

TEST_CASE("every golden image has the command that makes it, and each name is there once") {
  std::set<std::string> named;
  for (const Line& line : read_commands()) {
    INFO(line.file);
    CHECK(named.insert(line.file).second);
  }
  for (const auto& entry : std::filesystem::directory_iterator(kGolden)) {
    if (entry.path().extension() != ".png") continue;
    INFO(entry.path().string());
    CHECK(named.count(entry.path().filename().string()) == 1);
  }
}

TEST_CASE("a golden image says by which scene and options it was made") {
  for (const Line& line : read_commands()) {
    if (line.arguments.front() != "render") continue;
    INFO(line.file);
    const auto bytes = read_file(kGolden + line.file);
    REQUIRE(bytes);
    const auto text = read_png_text(*bytes);
    REQUIRE(text);
    const auto recipe = recipe_of(*text);
    REQUIRE(recipe);
    std::vector<std::string> words{"render", recipe->scene};
    words.insert(words.end(), recipe->options.begin(), recipe->options.end());
    std::vector<std::string> expected = line.arguments;
    std::sort(words.begin(), words.end());  // a recipe has its options in their own order
    std::sort(expected.begin(), expected.end());
    CHECK(words == expected);
  }
}

}  // namespace
}  // namespace glassbox::test
