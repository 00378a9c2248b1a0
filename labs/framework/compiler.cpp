#include "labs/framework/compiler.h"

#include <cstdlib>
#include <system_error>

namespace glassbox::labs {

namespace fs = std::filesystem;

std::string compiler() {
  if (const char* named = std::getenv("CXX"); named != nullptr && *named != '\0') return named;
  std::error_code error;
  if (fs::exists(GLASSBOX_LABS_COMPILER, error)) return GLASSBOX_LABS_COMPILER;
  return "c++";
}

std::vector<fs::path> dependencies_of(const std::string& rule) {
  std::vector<fs::path> files;
  std::string word;
  const std::size_t colon = rule.find(": ");
  const auto finish = [&] {
    if (!word.empty()) files.emplace_back(word);
    word.clear();
  };
  for (std::size_t i = colon == std::string::npos ? rule.size() : colon + 2; i < rule.size(); ++i) {
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    if (rule[i] == '\\' && next == '\n') {
      finish();
      ++i;
    } else if (rule[i] == '\\' && (next == ' ' || next == '#' || next == '\\')) {
      word += next;
      ++i;
    } else if (rule[i] == ' ' || rule[i] == '\n') {
      finish();
    } else {
      word += rule[i];
    }
  }
  finish();
  return files;
}

}  // namespace glassbox::labs
