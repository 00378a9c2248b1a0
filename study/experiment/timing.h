// Times that may be compared with each other: all works are repeated in turn, so that what disturbs the machine disturbs
// all of them alike; and what disturbed one of them is seen.
#pragma once

#include <functional>
#include <vector>

#include <glassbox/base/processor_time.h>

#include "study/bench/statistics.h"

namespace glassbox::study {

struct TimedWork {
  std::function<void()> work;
  double items = 1;
  int threads = 1;  // that it keeps busy
};

struct Timed {
  Quartiles ns;  // for one item
  // Of the samples, those during which the machine did something else, and that another round did not make up for.
  int disturbed = 0;
};

// The processor's seconds for 100,000 products, each of which waits for the one before.
double seconds_of_products();

// What tells whether the machine did something else.
struct Probes {
  std::function<double()> reference_seconds = seconds_of_products;
  std::function<long()> switches = involuntary_switches;
};

// Each once without a clock, then `repetitions` rounds over all of them, each round beginning one further on, so that
// nobody always runs behind the same neighbour. A work shorter than kLeastSample is called several times a sample.
//
// One thread's time is the processor's: what others take meanwhile is not in it. Where the clock on the wall went on for more
// than kMostWaiting beyond it, the thread had to wait, and finds its caches changed: the sample is disturbed. Several
// threads' time is the wall's; a sample in which one of them had to give way is disturbed, as the others may have waited for
// it. So is, for both, a round in which the reference takes kMostSlower of its least time: the processor itself was
// slower. Up to as many rounds again replace disturbed samples.
std::vector<Timed> time_in_turn(const std::vector<TimedWork>& works, int repetitions,
                                const Probes& probes = {});

inline constexpr double kLeastSample = 2e-4;  // seconds; a clock's reading takes some 5e-8
inline constexpr double kMostWaiting = 0.05;  // of the sample
inline constexpr double kMostSlower = 1.1;

}  // namespace glassbox::study
