// Makes the error for something that this OpenGL cannot do.
#pragma once

#include <string>

#include <glassbox/base/error.h>

namespace glassbox::study {

inline tl::unexpected<Error> refused(const std::string& cause) {
  return fail("OpenGL", cause, "try another version of Mesa, or leave --against out");
}

}  // namespace glassbox::study
