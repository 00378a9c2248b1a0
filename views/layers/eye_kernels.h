// The inner loops of warping one eye's picture to the other's, compiled once for each instruction
// set. They use floats in one written order and integers, so that every target gives the same
// bytes.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// Along a row, a pixel of one eye appears in the other eye's row at x + at_infinity - by_nearness *
// nearness. The nearness is 1 at the near plane and 0 where there is no surface: near / distance,
// or in a parallel view (far - distance) / (far - near). In both cases it is linear in the stored
// depth: offset + slope * depth.
struct EyeShift {
  DepthFormat format;
  float offset, slope;
  float at_infinity, by_nearness;  // px
};

struct EyeRow {
  const Rgba8* color;
  const std::uint32_t* depth;  // depth codes
  int width;
  // First layer: its empty pixels show the background; those of other layers show nothing.
  bool is_first;
};

// The other eye's row while it is made: its colours, and their nearness as its bits + 1 (0 for a
// hole). Each array has one number more than there are pixels: pixels outside of the row are
// written there, and its value has no meaning.
struct EyeTarget {
  std::uint32_t* color;
  std::uint32_t* nearness;
};

struct EyeKernels {
  // Warps a row into the target. The nearer pixel stays; of equally near ones, the first. `scratch`
  // has room for 2 width + 256 numbers.
  void (*warp_row)(const EyeShift& shift, const EyeRow& row, float* scratch, const EyeTarget& to);

  // Fills holes from the pixel beside them, the farther one of both sides. A row to which nothing
  // was warped gets the colour that the caller has put into its pixel 0. Returns the number of
  // pixels filled.
  int (*fill)(const EyeTarget& row, int width);
};

const EyeKernels& eye_kernels(Target target);

}  // namespace glassbox::views
