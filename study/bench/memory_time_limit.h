// The time that no rasterizer can beat on this machine: the bytes that a scene has to move, divided
// by the memory's bandwidth.
#pragma once

#include "study/scenes/scenes.h"

namespace glassbox::study {

struct Floor {
  int threads = 1;
  double read_bytes_per_second = 0, written_bytes_per_second = 0;
  double operations_per_second = 0;  // float multiplications and additions, not fused
};

// Measures the bandwidth of the memory with loops over more memory than every cache holds, and the
// operations with a loop that needs no memory. Takes the best of several runs.
Floor measure_floor(int threads);

// The bytes that must move at least between memory and processor for a frame. Vertices (their
// tables as stored), 32-bit indices and textures are read once in each pass; colours are written
// once in the frame, depths once in each pass.
struct Traffic {
  double read_bytes = 0, written_bytes = 0;
};
Traffic least_traffic(const BenchScene& bench);

inline double floor_ms(const Floor& floor, const Traffic& traffic) {
  return 1000 * (traffic.read_bytes / floor.read_bytes_per_second +
                 traffic.written_bytes / floor.written_bytes_per_second);
}

}  // namespace glassbox::study
