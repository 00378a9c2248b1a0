// What no rasterizer can be faster than on this machine: the bytes that a scene has to move, over what its memory moves.
#pragma once

#include "study/scenes/scenes.h"

namespace glassbox::study {

struct Floor {
  int threads = 1;
  double read_bytes_per_second = 0, written_bytes_per_second = 0;
  double operations_per_second = 0;  // float multiplications and additions, not fused
};

// By loops over memory that no cache holds, the best of several runs.
Floor measure_floor(int threads);

// Everything moved once: vertices (their tables as they are), 32-bit indices and textures read in each pass; colours
// written once, and depths in each pass.
struct Traffic {
  double read_bytes = 0, written_bytes = 0;
};
Traffic least_traffic(const BenchScene& bench);

inline double floor_ms(const Floor& floor, const Traffic& traffic) {
  return 1000 * (traffic.read_bytes / floor.read_bytes_per_second +
                 traffic.written_bytes / floor.written_bytes_per_second);
}

}  // namespace glassbox::study
