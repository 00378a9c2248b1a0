// How long something took, by a clock that is never set forward or back.
#pragma once

#include <chrono>

namespace glassbox {

// The milliseconds since the time point `since`, never negative.
inline double elapsed_ms(std::chrono::steady_clock::time_point since) {
  const auto now = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::milli>(now - since).count();
}

}  // namespace glassbox
