// Runs every line of images/golden/commands.txt as it is written: it must make the picture of that
// name in the same folder. With the version of zlib that compressed the golden files, the file must
// be the same byte for byte.
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/images/temporary_directory.h"
#include "tests/support/run_program.h"
#include "tests/support/skip.h"

#include <glassbox/compare/testing/catch2.h>
#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/images/write.h>

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

// Runs the line's command with more arguments. Returns a description of the failure, or "".
std::string make(const Line& line, const std::vector<std::string>& more,
                 const std::string& picture) {
  std::vector<std::string> arguments = line.arguments;
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.insert(arguments.end(), {"-o", picture});
  const Outcome outcome = run_program(GLASSBOX_PROGRAM, arguments, kGolden);
  // the picture shows a difference: exit code 1
  const int expected = line.arguments.front() == "diff" ? 1 : 0;
  if (outcome.exit_code == expected) return "";
  return "exit code " + std::to_string(outcome.exit_code) + ": " + outcome.err;
}

// Returns the version of zlib that compressed the golden files. Another version may write the same
// pixels with other bytes.
std::string recorded_zlib() {
  std::string version;
  std::ifstream(kGolden + "zlib-version") >> version;
  return version;
}

// Returns the bytes that the file would have if it were written today: its own pixels and text,
// encoded again.
std::vector<std::byte> written_anew(const std::vector<std::byte>& file) {
  const auto image = decode_stored(file);
  REQUIRE(image);
  const auto text = read_png_text(file);
  REQUIRE(text);
  const auto written = encode_png(*image, *text);
  REQUIRE(written);
  return *written;
}

void check_all(const std::vector<Line>& lines, const std::vector<std::string>& more) {
  const TemporaryDirectory directory;
  for (const Line& line : lines) {
    const std::string picture = directory.file(line.file);
    INFO("images/golden/" << line.file);
    REQUIRE(make(line, more, picture) == "");
    CHECK_THAT(PictureFile{picture}, MatchesGolden(kGolden + line.file));
    const auto made = read_file(picture), golden = read_file(kGolden + line.file);
    REQUIRE(made);
    REQUIRE(golden);
    // The recipe in a file names the version of the program, so a file of another version has
    // another text.
    const bool same_text = *read_png_text(*made) == *read_png_text(*golden);
    if (same_text && recorded_zlib() == zlibVersion()) CHECK(*made == *golden);
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

TEST_CASE("a golden file has the bytes that are written today") {
  if (recorded_zlib() != zlibVersion())
    SKIP_TEST("the golden files were compressed by zlib " << recorded_zlib()
                                                          << ", and this is zlib " << zlibVersion()
                                                          << ": their pixels are compared alone");
  for (const Line& line : read_commands()) {
    // A heat map has a palette, which is lost here. check_all compares the file that diff writes.
    if (line.arguments.front() == "diff") continue;
    INFO("images/golden/" << line.file << ": make it again with images/golden/make.sh");
    const auto file = read_file(kGolden + line.file);
    REQUIRE(file);
    CHECK(written_anew(*file) == *file);
  }
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
    std::sort(words.begin(), words.end());  // the options of a recipe have an order of their own
    std::sort(expected.begin(), expected.end());
    CHECK(words == expected);
  }
}

}  // namespace
}  // namespace glassbox::test
