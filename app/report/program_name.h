// The name under which the user called the program.
#pragma once

#include <cstdlib>
#include <string>

namespace glassbox::app {

// What commands that the program suggests begin with: the launcher of a clone hands over its own name.
inline std::string program_name() {
  const char* invoked_as = std::getenv("GLASSBOX_INVOKED_AS");
  return invoked_as != nullptr ? invoked_as : "glassbox";
}

}  // namespace glassbox::app
