// The inner loops of warping one eye's picture to the other's, compiled once for each instruction
// set. They use integers, and floats in the order of operations that the code states, so that the
// result has the same bytes for every instruction set.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// A pixel at column x of one eye's row appears in the other eye's row at x + at_infinity -
// by_nearness * nearness. The nearness is 1 at the near plane and 0 where there is no surface: near
// / distance, or in a parallel view (far - distance) / (far - near). In both cases it is linear in
// the stored depth: offset + slope * depth.
struct EyeShift {
  DepthFormat format;
  float offset, slope;
  float at_infinity, by_nearness;  // px
};

struct EyeRow {
  const Rgba8* color;
  const std::uint32_t* depth;  // as codes of a DepthFormat
  int width;
  // Whether this is the first layer: its empty pixels show the background, while empty pixels of
  // other layers show nothing.
  bool is_first;
};

// The other eye's row while it is made: the colours, and the nearness of each pixel as the bits of
// a float, plus 1 (0 for a hole). Each array has one element more than the row has pixels: pixels
// outside of the row are written there, and its value has no meaning.
struct EyeTarget {
  std::uint32_t* color;
  std::uint32_t* nearness;
};

struct EyeKernels {
  // Warps a row into the target `to`. Where several pixels meet, the nearest one stays; of equally
  // near ones, the first. `scratch` has room for 2 width + 256 numbers.
  void (*warp_row)(const EyeShift& shift, const EyeRow& row, float* scratch, const EyeTarget& to);

  // Fills each hole with the colour of the pixel to its left or to its right, whichever is farther
  // away. A row to which nothing was warped gets the colour that the caller has put into its pixel
  // 0. Returns the number of pixels filled.
  int (*fill)(const EyeTarget& row, int width);
};

const EyeKernels& eye_kernels(Target target);

}  // namespace glassbox::views
