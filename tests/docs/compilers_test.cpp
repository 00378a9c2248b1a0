// What g++ 12 compiles and clang++ 14, Debian 12's, does not, so that it is found where no clang++ runs: algorithms that return a
// subrange, and views. (It checks the concepts of a view before the view is a complete class.)
#include <string>
#include <vector>

#include "tests/docs/tree.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

std::vector<std::string> not_compiled() {
  std::vector<std::string> words{std::string("std::") + "views::"};
  for (const char* name :
       {"unique", "remove", "remove_if", "rotate", "search", "search_n", "partition",
        "stable_partition", "find_end", "equal_range", "subrange"}) {
    for (const char* next : {"(", "<"}) words.push_back(std::string("ranges::") + name + next);
  }
  return words;
}

}  // namespace

TEST_CASE("no source uses the ranges of g++'s library that clang++ does not compile") {
  const std::vector<std::string> words = not_compiled();
  std::vector<std::string> found;
  std::size_t sources = 0;
  for (const std::string& file : text_files()) {
    if (!file.ends_with(".cpp") && !file.ends_with(".h")) continue;
    ++sources;
    const std::vector<std::string> lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::string& word : words) {
        if (lines[i].find(word) == std::string::npos) continue;
        found.push_back(file + ":" + std::to_string(i + 1) + ": " + word);
      }
    }
  }
  CHECK(found == std::vector<std::string>());
  CHECK(sources > 1000);  // or they were not looked at
}

}  // namespace glassbox::test
