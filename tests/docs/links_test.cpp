// Checks that everything the pages at the top and in docs/ point to exists: linked files, and paths
// in the text.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/docs/tree.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// Returns all texts between `begin` and `end` in the line.
std::vector<std::string> between(const std::string& line, std::string_view begin,
                                 std::string_view end) {
  std::vector<std::string> all;
  for (std::size_t at = line.find(begin); at != line.npos; at = line.find(begin, at)) {
    at += begin.size();
    const std::size_t stop = line.find(end, at);
    if (stop == line.npos) break;
    all.push_back(line.substr(at, stop - at));
    at = stop + end.size();
  }
  return all;
}

// Returns the file that a link leads to, as a path from the top of the tree. It is empty for links
// to other sites or within the same page.
std::string linked(const std::string& page, std::string link) {
  link = link.substr(0, link.find('#'));
  if (link.empty() || link.find("://") != link.npos) return {};
  return (std::filesystem::path(page).parent_path() / link).lexically_normal().generic_string();
}

// Whether the text is a path of the repository: one of its folders, then small letters, digits and
// _-./ only. (NN and NAME are placeholders.)
bool is_path(const std::string& text) {
  const std::array folders{"base/",     "compare/", "exact/",    "html/",    "images/", "include/",
                           "matrices/", "mesh/",    "pipeline/", "raster/",  "render/", "study/",
                           "labs/",     "app/",     "cli/",      "inspect/", "views/",  "docs/",
                           "tests/",    "debug/",   "cmake/",    "examples/"};
  return std::ranges::any_of(folders, [&](const char* f) { return text.starts_with(f); }) &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-./") == text.npos;
}

std::vector<std::string> pages() {
  std::vector<std::string> all;
  for (const std::string& file : text_files()) {
    const bool at_top = file.find('/') == file.npos;
    if (file.ends_with(".md") && (at_top || file.starts_with("docs/"))) all.push_back(file);
  }
  return all;
}

}  // namespace

TEST_CASE("every file that the pages at the top and in docs/ point to is there") {
  int links = 0, paths = 0;
  for (const std::string& page : pages()) {
    bool in_block = false;
    for (const std::string& line : lines_of(page)) {
      if (line.starts_with("```")) in_block = !in_block;
      if (in_block) continue;
      CAPTURE(page, line);
      for (const std::string& link : between(line, "](", ")")) {
        const std::string file = linked(page, link);
        if (file.empty()) continue;
        CHECK(exists(tree() / file));
        ++links;
      }
      for (const std::string& text : between(line, "`", "`")) {
        if (!is_path(text)) continue;
        CHECK(exists(tree() / text));
        ++paths;
      }
    }
  }
  CHECK(links > 60);
  CHECK(paths > 60);
}

TEST_CASE("links and paths are found in a line") {
  using Texts = std::vector<std::string>;
  CHECK(between("[a](b.md) and [c](d.md#e)", "](", ")") == Texts{"b.md", "d.md#e"});
  CHECK(linked("docs/a.md", "../pipeline/clip.h") == "pipeline/clip.h");
  CHECK(linked("docs/a.md", "b.md#c") == "docs/b.md");
  CHECK(linked("docs/a.md", "https://example.org/").empty());
  CHECK(is_path("pipeline/clip.h"));
  CHECK_FALSE(is_path("labs/NN-name"));
  CHECK_FALSE(is_path("results/"));
}

}  // namespace glassbox::test
