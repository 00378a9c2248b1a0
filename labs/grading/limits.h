// What one process of a submission may use.
#pragma once

#include <cstddef>

namespace glassbox::labs::grading {

inline constexpr std::size_t kMiB = std::size_t(1) << 20;

struct Limits {
  double seconds = 10;  // of wall-clock time; the processor's time is limited to the next second
  std::size_t memory_bytes = 512 * kMiB;  // of address space; 0: no limit
  std::size_t stack_bytes = 8 * kMiB;     // what a student's own machine gives by default
  std::size_t file_bytes = kMiB;          // of each file it writes
  std::size_t output_bytes = 64 * kMiB;   // of answers; a process that writes more is ended
  std::size_t said_bytes = kMiB;          // of standard output and error together; likewise
  std::size_t kept_bytes = 16 * 1024;     // of those, what a report shows
  unsigned processes = 64;  // of the user that it runs as, where that is one of its own
};

// A compiler: cc1plus alone maps some 200 MiB for <iostream> and GLM.
inline Limits compile_limits() {
  Limits limits;
  limits.seconds = 60;
  limits.memory_bytes = 2048 * kMiB;
  limits.stack_bytes = 64 * kMiB;  // g++ raises its own to this
  limits.file_bytes = 64 * kMiB;
  return limits;
}

}  // namespace glassbox::labs::grading
