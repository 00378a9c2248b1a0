// The processor time of this program. Other work on the machine disturbs it less than the time on
// the clock.
#pragma once

#include <ctime>

#include <sys/resource.h>

namespace glassbox {

// Processor time of all threads together, in milliseconds.
inline double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

// How often a thread of this program was interrupted so that another could use its processor.
inline long involuntary_switches() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_nivcsw;
}

}  // namespace glassbox
