// How long something took, by a clock that is never set forward or back.
#pragma once

#include <chrono>

namespace glassbox {

// Milliseconds since `since`, >= 0.
inline double elapsed_ms(std::chrono::steady_clock::time_point since) {
  const auto now = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::milli>(now - since).count();
}

}  // namespace glassbox
