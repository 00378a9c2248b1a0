// Command lines that the program suggests.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/program_name.h"

#include <glassbox/images/recipe.h>

namespace glassbox::app {

// The program's name and the words, as a POSIX shell reads them back; none where shell_quoted has none for one of them.
inline std::optional<std::string> shell_line(const std::vector<std::string>& words) {
  auto line = shell_quoted(program_name());
  for (const std::string& word : words) {
    const auto quoted = shell_quoted(word);
    if (!line || !quoted) return std::nullopt;
    *line += " " + *quoted;
  }
  return line;
}

}  // namespace glassbox::app
