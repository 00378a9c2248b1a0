// The inner loops of warping one eye's picture to the other's, compiled once for each instruction set: floats in one written order and
// integers, so that every target gives the same bytes.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// Along a row, a pixel of the one eye is found in the other's at x + at_infinity - by_nearness * nearness. The nearness is 1 at the near
// plane and 0 where nothing is: near / distance, or in a parallel view (far - distance) / (far - near). Of both it is linear in the
// depth that is stored: offset + slope * depth.
struct EyeShift {
  DepthFormat format;
  float offset, slope;
  float at_infinity, by_nearness;  // px
};

struct EyeRow {
  const Rgba8* color;
  const std::uint32_t* depth;  // codes
  int width;
  bool is_first;  // layer: its empty pixels are the background's; those of others are nothing
};

// The other eye's row on its way: what it shows, and how near that is, a nearness's bits + 1; 0 where nothing came. One number more than
// pixels: the last one is rubbish.
struct EyeTarget {
  std::uint32_t* color;
  std::uint32_t* nearness;
};

struct EyeKernels {
  // Carries a row into the target, where what is nearer stays, and of what is equally near what came first. `scratch` has room for
  // 2 width + 256 numbers.
  void (*carry)(const EyeShift& shift, const EyeRow& row, float* scratch, const EyeTarget& to);

  // Holes get what is beside them, of both sides the farther; a row to which nothing came, the colour
  // that its pixel 0 has had from the beginning. How many pixels they were.
  int (*fill)(const EyeTarget& row, int width);
};

const EyeKernels& eye_kernels(Target target);

}  // namespace glassbox::views
