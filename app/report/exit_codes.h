// What the program's exit says.
#pragma once

#include <cstddef>
#include <cstdio>

#include <fmt/format.h>

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

inline constexpr int kSuccess = 0;
inline constexpr int kFailure = 1;   // something failed, or a difference was found
inline constexpr int kBadInput = 2;  // usage, or a file that is refused

// An error repeats what was typed and what stands in files: both may be anything. Longer than this is no line to read.
inline constexpr std::size_t kLongestMessage = 4000;

inline int refuse(const Error& error) {
  fmt::print(stderr, "glassbox: {}\n", printable(error.message(), kLongestMessage));
  return kBadInput;
}

}  // namespace glassbox::app
