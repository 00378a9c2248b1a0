// Command lines that the program suggests to the user.
#pragma once

#include <string>
#include <vector>

#include "cli/report/program_name.h"

#include <glassbox/images/recipe.h>

namespace glassbox {

// The program's name and the words of all parts, quoted for a POSIX shell. Empty if shell_quoted
// cannot quote one of them.
inline std::string shell_line(const std::vector<std::vector<std::string>>& parts) {
  auto line = shell_quoted(program_name());
  for (const std::vector<std::string>& words : parts) {
    for (const std::string& word : words) {
      const auto quoted = shell_quoted(word);
      if (!line || !quoted) return {};
      *line += " " + *quoted;
    }
  }
  return line.value_or("");
}

}  // namespace glassbox
