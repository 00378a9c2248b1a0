// "Data flows down this list, and no file includes one that stands further down": README's list of folders.
#include <algorithm>
#include <cstddef>
#include <filesystem>
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

// The included file, from the top of the tree: <glassbox/a/b.h>, "a/b.h" from there, or "b.h" and "../a/b.h" from the
// including file's own folder. Empty where the line includes nothing.
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

// Whether `file` may not include what the line includes.
bool runs_back(const std::vector<std::string>& folders, const std::string& file,
               const std::string& line) {
  const auto place = [&](const std::string& path) {
    return std::ranges::find(folders, path.substr(0, path.find('/'))) - folders.begin();
  };
  const auto of_included = place(included_by(file, line));
  return of_included < std::ptrdiff_t(folders.size()) && of_included > place(file);
}

bool is_source(const std::string& file) {
  return file.ends_with(".h") || file.ends_with(".cpp");
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
  for (const char* line : {"#include <glassbox/render/trace.h>", "#include \"render/trace.h\"",
                           "#include \"../render/trace.h\"", "#  include \"tests/app/run.h\" // x",
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

}  // namespace glassbox::test
