// The program's exit codes.
#pragma once

#include <cstddef>
#include <cstdio>

#include <fmt/format.h>

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>

namespace glassbox {

inline constexpr int kSuccess = 0;
inline constexpr int kFailure = 1;   // something failed, or a difference was found
inline constexpr int kBadInput = 2;  // wrong usage, or a file that is refused

// Errors repeat words of the user and texts from files, which can be very long. Longer messages are
// cut.
inline constexpr std::size_t kLongestMessage = 4000;
inline constexpr std::size_t kLongPath = 1000;  // longest path of a file in a report

inline int refuse(const Error& error) {
  fmt::print(stderr, "glassbox: {}\n", printable(error.message(), kLongestMessage));
  return kBadInput;
}

}  // namespace glassbox
