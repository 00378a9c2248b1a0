// The name by which the user called the program.
#pragma once

#include <cstdlib>
#include <string>

namespace glassbox {

// The program's name in suggested commands. The launcher script of a clone passes its own name on.
inline std::string program_name() {
  const char* invoked_as = std::getenv("GLASSBOX_INVOKED_AS");
  return invoked_as != nullptr ? invoked_as : "glassbox";
}

}  // namespace glassbox
