// Positions become integers: 1/256 pixel, halves rounded up.
#pragma once

#include <cmath>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// `pixels` times 256 is exact (a power of two), and so is the comparison of the remainder with one half;
// floor(pixels * 256 + 0.5f) would round wrongly just below a half, and beyond 2^15 pixels.
inline std::int32_t snap(float pixels) {
  const float subpixels = pixels * float(kSubpixels);
  const float below = std::floor(subpixels);
  return std::int32_t(below) + (subpixels - below >= 0.5f ? 1 : 0);
}

// |position| < 2^16 pixels (SnappedVertex), which clipping to the guard band guarantees.
inline SnappedVertex snap(const ScreenVertex& vertex) {
  return {snap(vertex.position.x), snap(vertex.position.y)};
}

}  // namespace glassbox
