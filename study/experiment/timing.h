// Measures times that can be compared with each other: all works are repeated in turn, so that a
// disturbance of the machine affects all of them alike, and samples that were disturbed are
// recognized.
#pragma once

#include <functional>
#include <vector>

#include <glassbox/base/processor_time.h>

#include "study/bench/statistics.h"

namespace glassbox::study {

struct TimedWork {
  std::function<void()> work;
  double items = 1;
  int threads = 1;  // number of threads that the work keeps busy
};

struct Timed {
  Quartiles ns;  // per item
  // The number of samples that were taken while the machine did something else, and that had to be
  // kept because there were not enough undisturbed samples in other rounds.
  int disturbed = 0;
};

// What a report says below a table that marks times with this word.
inline constexpr const char* kDisturbedMeaning =
    "disturbed: another program used the machine while this was measured; on a quiet machine the "
    "time may be shorter";

// The processor time, in seconds, of 100,000 multiplications, each with the result of the one
// before.
double seconds_of_products();

// The functions that show whether the machine did something else: the time of a fixed piece of
// work, and the number of times that a thread was interrupted.
struct Probes {
  std::function<double()> reference_seconds = seconds_of_products;
  std::function<long()> switches = involuntary_switches;
};

// Calls each work once without timing, then times `repetitions` rounds over all works. Each round
// starts with the next work, so that no work always runs right after the same one. A work shorter
// than kMinSample is called several times per sample.
//
// With one thread, the time is processor time, which does not include the time that other programs
// take. If the wall clock exceeds it by more than kMaxWaiting, the thread had to wait and its
// caches may have changed: the sample is disturbed. With several threads, the time is wall time; a
// sample in which one of the threads was interrupted is disturbed, because the other threads may
// have waited for it. In both cases a round is disturbed if the reference work takes more than
// kMaxSlower times its least time: then the processor itself was slower. Disturbed samples are
// replaced by samples of additional rounds; there are at most as many additional rounds as first
// ones.
std::vector<Timed> time_in_turn(const std::vector<TimedWork>& works, int repetitions,
                                const Probes& probes = {});

inline constexpr double kMinSample = 2e-4;   // seconds; reading a clock takes about 5e-8
inline constexpr double kMaxWaiting = 0.05;  // fraction of the sample's time
inline constexpr double kMaxSlower = 1.1;

}  // namespace glassbox::study
