// The limits of one process of a submission.
#pragma once

#include <cstddef>

namespace glassbox::labs::grading {

inline constexpr std::size_t kMiB = std::size_t(1) << 20;

struct Limits {
  // wall-clock time; the limit on processor time is this, rounded up, and one second more
  double seconds = 10;
  std::size_t memory_bytes = 512 * kMiB;  // address space; 0: no limit
  std::size_t stack_bytes = 8 * kMiB;     // the usual default on a student's own machine
  std::size_t file_bytes = kMiB;          // for each file that the process writes
  std::size_t output_bytes = 64 * kMiB;   // for answers; a process that writes more is ended
  // of standard output and standard error together; a process that writes more is ended
  std::size_t printed_bytes = kMiB;
  std::size_t kept_bytes = 16 * 1024;  // how much of standard output and error a report shows
  unsigned processes = 64;             // of the user; only if the process has a user of its own
};

// The limits for a compiler: cc1plus alone maps some 200 MiB for <iostream> and GLM.
inline Limits compile_limits() {
  Limits limits;
  limits.seconds = 60;
  limits.memory_bytes = 2048 * kMiB;
  limits.stack_bytes = 64 * kMiB;  // g++ raises its own stack to this size
  limits.file_bytes = 64 * kMiB;
  return limits;
}

}  // namespace glassbox::labs::grading
