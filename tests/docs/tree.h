// Reads the project's files as text.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace glassbox::test {

inline const std::filesystem::path& tree() {
  static const std::filesystem::path root(GLASSBOX_SOURCE_DIR);
  return root;
}

inline std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream in(tree() / file, std::ios::binary);
  if (!in) throw std::runtime_error(file + " is not there");
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Returns the sorted paths, from the top of the tree, of the files that people write, without those
// that builds, git or fuzzers make.
inline std::vector<std::string> text_files() {
  namespace fs = std::filesystem;
  const std::array folders{".vscode", "app",   "base",     "cli",  "cmake",    "compare",
                           "debug",   "docs",  "exact",    "html", "images",   "include",
                           "inspect", "labs",  "matrices", "mesh", "pipeline", "raster",
                           "render",  "study", "tests",    "views"};
  const std::array kinds{".cmake", ".cpp", ".css", ".h",  ".html", ".in", ".js",
                         ".json",  ".md",  ".mjs", ".py", ".sh",   ".txt"};
  std::vector<std::string> files{"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "CMakeLists.txt"};
  for (const char* folder : folders) {
    if (!fs::is_directory(tree() / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree() / folder)) {
      const std::string file = entry.path().lexically_relative(tree()).generic_string();
      const bool kept = std::ranges::count(kinds, entry.path().extension().string()) > 0 &&
                        !file.starts_with("tests/fuzz/corpus/") && entry.is_regular_file();
      if (kept) files.push_back(file);
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace glassbox::test
