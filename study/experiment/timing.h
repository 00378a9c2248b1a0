// Times that may be compared with each other: all works are repeated in turn, so that what disturbs the machine disturbs
// all of them alike.
#pragma once

#include <functional>
#include <vector>

#include "study/bench/statistics.h"

namespace glassbox::study {

struct TimedWork {
  std::function<void()> work;
  double items = 1;
};

// Each once without a clock, then `repetitions` rounds over all of them, each round beginning one further on, so that
// nobody always runs behind the same neighbour. A work shorter than kLeastSample is called several times a sample. The
// quartiles of nanoseconds for one item.
std::vector<Quartiles> time_in_turn(const std::vector<TimedWork>& works, int repetitions);

inline constexpr double kLeastSample = 2e-4;  // seconds; a clock's reading takes some 5e-8

}  // namespace glassbox::study
