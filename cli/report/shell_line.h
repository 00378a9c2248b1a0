// Command lines that the program suggests, and the name under which the user called it.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include <glassbox/images/recipe.h>

namespace glassbox {

// The program's name in suggested commands. The launcher script ./glassbox passes its own name to
// the program in the environment.
inline std::string program_name() {
  const char* invoked_as = std::getenv("GLASSBOX_INVOKED_AS");
  return invoked_as != nullptr ? invoked_as : "glassbox";
}

// The program's name and the words of all parts, quoted for a POSIX shell. Empty if shell_quoted
// cannot quote a word.
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
