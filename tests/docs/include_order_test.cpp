// Checks the rule of README's list of folders: "Data flows down this list, and no file includes one
// that stands further down". It also checks that no folders, subfolders among them, include each
// other in a circle.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/docs/tree.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

std::vector<std::string> folders_of_readme() {
  std::vector<std::string> folders;
  bool listed = false;
  for (const std::string& line : lines_of("README.md")) {
    if (line.starts_with("## ")) listed = line == "## The house";
    const std::size_t slash = line.find("/ ");
    if (listed && slash < line.find(' ')) folders.push_back(line.substr(0, slash));
  }
  return folders;
}

// Returns the included file as a path from the top of the tree. The line may include
// <glassbox/a/b.h>, "a/b.h" from the top, or "b.h" and "../a/b.h" from the folder of the including
// file. The result is empty if the line includes nothing.
std::string included_by(const std::string& file, const std::string& line) {
  const std::size_t begin = line.find_first_of("<\"");
  const std::size_t hash = line.find_first_not_of(' ');
  if (begin == std::string::npos || !line.substr(hash).starts_with('#') ||
      line.find("include") > begin) {
    return {};
  }
  const std::string name = line.substr(begin + 1, line.find_first_of(">\"", begin + 1) - begin - 1);
  const std::string installed = "glassbox/";
  if (name.starts_with(installed)) return name.substr(installed.size());
  if (line[begin] == '<') return {};
  const auto beside = (std::filesystem::path(file).parent_path() / name).lexically_normal();
  return name.starts_with("..") || exists(tree() / beside) ? beside.generic_string() : name;
}

bool of_commands(const std::string& path) {
  return path.substr(path.find('/') + 1).starts_with("commands/");
}

// Whether the line includes a file that `file` must not include.
bool runs_back(const std::vector<std::string>& folders, const std::string& file,
               const std::string& line) {
  const auto place = [&](const std::string& path) {
    return std::ranges::find(folders, path.substr(0, path.find('/'))) - folders.begin();
  };
  const std::string included = included_by(file, line);
  if (of_commands(included) && !of_commands(file) && place(file) < place("app")) return true;
  const auto of_included = place(included);
  return of_included < std::ptrdiff_t(folders.size()) && of_included > place(file);
}

bool is_source(const std::string& file) {
  return file.ends_with(".h") || file.ends_with(".cpp");
}

std::string folder_of(const std::string& file) {
  return std::filesystem::path(file).parent_path().generic_string();
}

// For each folder, the folders from which its files include something.
using Arrows = std::map<std::string, std::set<std::string>>;

Arrows arrows_of_tree() {
  Arrows arrows;
  for (const std::string& file : text_files()) {
    if (!is_source(file) || file.starts_with("tests/")) continue;
    for (const std::string& line : lines_of(file)) {
      const std::string included = included_by(file, line);
      if (included.empty() || !exists(tree() / included)) continue;
      const std::string from = folder_of(file), to = folder_of(included);
      if (from != to) arrows[from].insert(to);
    }
  }
  return arrows;
}

// Returns the folders of a circle, in order, or nothing. Folders that include none of the remaining
// folders are in no circle and are removed first.
std::vector<std::string> circle_in(Arrows arrows) {
  std::size_t removed = 0;
  do {
    for (auto& [from, targets] : arrows) {
      std::erase_if(targets, [&](const std::string& to) { return !arrows.contains(to); });
    }
    removed = std::erase_if(arrows, [](const auto& folder) { return folder.second.empty(); });
  } while (removed > 0);
  if (arrows.empty()) return {};
  std::vector<std::string> way{arrows.begin()->first};
  for (;;) {
    const std::string& next = *arrows[way.back()].begin();
    const auto seen = std::ranges::find(way, next);
    if (seen != way.end()) return {seen, way.end()};
    way.push_back(next);
  }
}

}  // namespace

TEST_CASE("no file includes one that stands further down README's list of folders") {
  const std::vector<std::string> folders = folders_of_readme();
  CAPTURE(folders);
  REQUIRE(folders.size() >= 10);
  REQUIRE(folders.front() == "base");
  REQUIRE(folders.back() == "tests");
  int includes = 0;
  for (const std::string& file : text_files()) {
    if (!is_source(file)) continue;
    for (const std::string& line : lines_of(file)) {
      if (included_by(file, line).empty()) continue;
      ++includes;
      CAPTURE(file, line);
      CHECK_FALSE(runs_back(folders, file, line));
    }
  }
  CHECK(includes > 3000);
}

TEST_CASE("an include that runs back is found, in every way to write it") {
  const std::vector<std::string> folders = folders_of_readme();
  const std::string file = "raster/snap.h";
  for (const char* line :
       {"#include <glassbox/render/trace.h>", "#include \"render/trace.h\"",
        "#include \"../render/trace.h\"", "#  include \"tests/app/working_directory.h\" // x",
        "#include <glassbox/app/options.h>"}) {
    CAPTURE(line);
    CHECK(runs_back(folders, file, line));
  }
  for (const char* line :
       {"#include <glassbox/base/spaces.h>", "#include \"raster/stages.h\"", "#include <vector>",
        "#include \"stages.h\"", "#include <boost/render/x.h>", "// see \"render/trace.h\""}) {
    CAPTURE(line);
    CHECK_FALSE(runs_back(folders, file, line));
  }
}

TEST_CASE("a library that includes commands is found, and commands may include libraries") {
  const std::vector<std::string> folders = folders_of_readme();
  const auto back = [&](const std::string& file, const std::string& included) {
    return runs_back(folders, file, "#include \"" + included + "\"");
  };
  CHECK(back("views/klt/globe.cpp", "views/commands/klt_report.h"));
  CHECK(back("labs/framework/judge_check.cpp", "study/commands/text.h"));
  CHECK(back("views/commands/klt_report.cpp", "study/commands/text.h"));
  CHECK(back("cli/run_program.cpp", "app/commands.h"));
  CHECK_FALSE(back("views/commands/klt_report.cpp", "views/klt/globe.h"));
  CHECK_FALSE(back("views/commands/klt_report.cpp", "views/commands/klt_report.h"));
  CHECK_FALSE(back("study/commands/bench/matching.h", "views/commands/match_input.h"));
  CHECK_FALSE(back("app/main.cpp", "views/commands/commands.h"));
}

TEST_CASE("no folders include each other in a circle") {
  const Arrows arrows = arrows_of_tree();
  REQUIRE(arrows.size() > 30);
  REQUIRE(arrows.at("render/tile").contains("render/engine"));
  CHECK(circle_in(arrows) == std::vector<std::string>{});
}

TEST_CASE("a circle of folders is found, however long") {
  using Names = std::vector<std::string>;
  CHECK(circle_in({{"a", {"b", "c"}}, {"b", {"c"}}}) == Names{});
  CHECK(circle_in({{"a", {"b"}}, {"b", {"c", "d"}}, {"c", {"b"}}}) == Names{"b", "c"});
  CHECK(circle_in({{"a", {"a/b"}}, {"a/b", {"d"}}, {"d", {"a"}}}) == Names{"a", "a/b", "d"});
}

}  // namespace glassbox::test
