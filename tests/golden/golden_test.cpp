// The golden images: every line of images/golden/commands.txt, run as it stands, gives the picture beside it.
#include "tests/support/catch.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/images/temporary_directory.h"
#include "tests/support/run_program.h"

#include <glassbox/images/read.h>

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

std::string text_of(const Rgba8& p) {
  std::ostringstream text;
  text << '(' << int(p.r) << ',' << int(p.g) << ',' << int(p.b) << ',' << int(p.a) << ')';
  return text.str();
}

// "" if they are the same, else how they differ.
std::string difference(const Image<Rgba8>& golden, const Image<Rgba8>& found) {
  std::ostringstream text;
  if (golden.width != found.width || golden.height != found.height) {
    text << "golden " << golden.width << " x " << golden.height << ", found " << found.width
         << " x " << found.height;
    return text.str();
  }
  std::size_t count = 0;
  std::ostringstream first;
  for (int y = 0; y < golden.height; ++y) {
    for (int x = 0; x < golden.width; ++x) {
      const Rgba8& expected = golden.at(x, y);
      const Rgba8& pixel = found.at(x, y);
      if (expected == pixel) continue;
      if (count++ == 0) {
        first << '(' << x << ", " << y << "): golden " << text_of(expected) << ", found "
              << text_of(pixel);
      }
    }
  }
  if (count > 0) text << count << " pixels differ, the first at " << first.str();
  return text.str();
}

// Keeps the picture for somebody to look at, and says where.
std::string keep(const std::string& picture, const std::string& file) {
  const std::filesystem::path folder = GLASSBOX_FAILED_DIR;
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(picture, folder / file,
                             std::filesystem::copy_options::overwrite_existing);
  return "; kept as " + (folder / file).string();
}

std::string verdict(const Line& line) {
  const TemporaryDirectory directory;
  const std::string picture = directory.file(line.file);
  std::vector<std::string> arguments{"render"};
  arguments.insert(arguments.end(), line.arguments.begin(), line.arguments.end());
  arguments.insert(arguments.end(), {"-o", picture});
  const Outcome outcome = run_program(GLASSBOX_PROGRAM, arguments, kGolden);
  if (outcome.exit_code != 0) {
    return "exit code " + std::to_string(outcome.exit_code) + ": " + outcome.err;
  }
  const auto found = read_image(picture);
  if (!found) return found.error().message();
  const auto golden = read_image(kGolden + line.file);
  if (!golden) return golden.error().message() + keep(picture, line.file);
  const std::string differs = difference(*golden, *found);
  return differs.empty() ? "" : differs + keep(picture, line.file);
}

TEST_CASE("the golden commands give the golden images, byte for byte") {
  const std::vector<Line> lines = read_commands();
  REQUIRE(lines.size() >= 50);
  for (const Line& line : lines) {
    INFO("images/golden/" << line.file);
    CHECK(verdict(line) == "");
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

TEST_CASE("a difference of one bit in one pixel is found and named") {
  Image<Rgba8> golden(3, 2);
  Image<Rgba8> found = golden;
  CHECK(difference(golden, found) == "");
  found.at(2, 1).b ^= 1;
  CHECK(difference(golden, found) ==
        "1 pixels differ, the first at (2, 1): golden (0,0,0,255), found (0,0,1,255)");
  CHECK(difference(golden, Image<Rgba8>(2, 3)) == "golden 3 x 2, found 2 x 3");
}

}  // namespace
}  // namespace glassbox::test
