// What the program's exit says.
#pragma once

#include <cstdio>

#include <fmt/format.h>

#include <glassbox/base/error.h>

namespace glassbox::app {

inline constexpr int kSuccess = 0;
inline constexpr int kFailure = 1;   // something failed, or a difference was found
inline constexpr int kBadInput = 2;  // usage, or a file that is refused

inline int refuse(const Error& error) {
  fmt::print(stderr, "glassbox: {}\n", error.message());
  return kBadInput;
}

}  // namespace glassbox::app
