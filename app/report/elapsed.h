// How long something took, by a clock that is never set.
#pragma once

#include <chrono>

namespace glassbox::app {

inline double elapsed_ms(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since)
      .count();
}

}  // namespace glassbox::app
