// Measures the time of parts of a run.
#pragma once

#include <chrono>

#include <glassbox/base/elapsed.h>

namespace glassbox {

// Adds the wall-clock time between its construction and its destruction to a statistic.
class Stopwatch {
public:
  explicit Stopwatch(double& total_ms) : total_ms_(total_ms), start_(Clock::now()) {}
  ~Stopwatch() { total_ms_ += elapsed_ms(start_); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double& total_ms_;
  Clock::time_point start_;
};

}  // namespace glassbox
