// Runs the commands in the labs' handouts: they must make the pictures in the same folders.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/app/working_directory.h"
#include "tests/docs/shell.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

// Returns the commands of indented blocks, together with lines that a backslash joins to them.
std::vector<std::string> commands_of(const std::string& handout) {
  std::vector<std::string> commands;
  bool goes_on = false;
  for (const std::string& line : lines_of(handout)) {
    if (goes_on) {
      commands.back() += "\n" + line;
    } else if (line.starts_with("    glassbox ")) {
      commands.push_back(line);
    } else {
      continue;
    }
    goes_on = line.ends_with("\\");
  }
  return commands;
}

std::vector<fs::path> handouts() {
  std::vector<fs::path> all;
  for (const auto& folder : fs::directory_iterator(tree() / "labs")) {
    if (fs::exists(folder.path() / "handout.md"))
      all.push_back(folder.path().lexically_relative(tree()));
  }
  std::ranges::sort(all);
  return all;
}

// Carries out the handout's sentence "The same with `--window inf` for the other one."
std::string naive_pair(std::string command) {
  command.replace(command.find("--window 5"), 10, "--window inf");
  command.replace(command.find("window.png"), 10, "naive.png");
  return command;
}

}  // namespace

TEST_CASE("the commands in the labs' handouts make the pictures beside them, pixel for pixel") {
  REQUIRE(handouts().size() >= 9);
  int pictures = 0;
  for (const fs::path& lab : handouts()) {
    const Clone clone;
    std::vector<std::string> expected;
    for (const auto& entry : fs::directory_iterator(tree() / lab)) {
      const fs::path name = entry.path().filename();
      if (name.extension() != ".png") {
        fs::copy(entry.path(), fs::path(clone.root()) / name, fs::copy_options::recursive);
      } else {
        expected.push_back(name.string());
      }
    }
    // The file that `glassbox lab start` makes.
    std::ofstream(fs::path(clone.root()) / "lab.json")
        << "{\"lab\": \"" << lab.filename().string() << "\"}\n";
    auto commands = commands_of((lab / "handout.md").generic_string());
    REQUIRE_FALSE(commands.empty());
    if (lab == "labs/09-stereo") commands.push_back(naive_pair(commands.front()));
    for (const std::string& command : commands) {
      const Outcome outcome = clone.run(command);
      CAPTURE(lab, command, outcome.err);
      CHECK(outcome.exit_code == 0);
    }
    for (const std::string& name : expected) {
      CAPTURE(lab, name);
      const std::string reference = (tree() / lab / name).string();
      const Outcome same = clone.run("glassbox diff '" + reference + "' " + name);
      CAPTURE(same.out, same.err);
      CHECK(same.exit_code == 0);
      ++pictures;
    }
  }
  CHECK(pictures >= 24);
}

}  // namespace glassbox::test
