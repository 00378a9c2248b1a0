// How long the processor has worked for this program: what others do to the machine counts less in it than on the clock.
#pragma once

#include <ctime>

#include <sys/resource.h>

namespace glassbox {

// Of all threads together, in milliseconds.
inline double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

// How often a thread of this program had to give its processor to another one.
inline long involuntary_switches() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_nivcsw;
}

}  // namespace glassbox
