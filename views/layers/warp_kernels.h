// The inner loops of drawing layers, compiled once for each instruction set: floats in one written order and integers, so that every
// target gives the same bytes.
#pragma once

#include <cstdint>
#include <span>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// What a pixel of a canvas holds: the bits of a depth, which ascend as the depth does, above those of the colour. The greater of two
// keys is the nearer sample; of two with one depth, the one whose colour is the greater number. 0: a hole.
using SampleKey = std::uint64_t;

// The greatest depth that is drawn: 1, the near plane's, and room for rounding. Of a sample there z w and w are up to four roundings off each
// (a coefficient, a product, two sums), 1/w and the last product one each: 10 u, u = 2^-24, of which this is 16.
inline constexpr float kNearestDepth = 1 + 0x1p-20f;

struct WarpedPoint {
  float x, y, z, w;  // times w
};

// Samples of one row, of pixels at most 64 apart.
struct WarpBlock {
  // Whole vectors are read: 64 bytes beyond the last one must be there.
  const float* depth;
  const std::uint32_t* color;
  const std::uint16_t* column;
  // How much the sample's surface gains in depth, a pixel to the right and a pixel down.
  const float *slope_x, *slope_y;
  int count;
  int anchor;  // the column that `start` is of
  WarpedPoint start, right,
      depth_step;  // a sample is at start + (column - anchor) right + its depth * depth_step
};

// A picture of keys with a pixel more on each side, so that what is drawn 3 x 3 pixels large may have its centre there.
struct KeyCanvas {
  SampleKey* keys;    // of pixel (-1, -1)
  int width, height;  // of the picture
  int stride() const { return width + 2; }
  // Behind the last one: where samples go that are not drawn.
  int nowhere() const { return stride() * (height + 2); }
};

// Pixels [left, right) x [top, bottom); none of a sample that is not drawn.
struct SampleBoxes {
  std::int32_t *left, *top, *right, *bottom;
  std::uint32_t* depth;  // bits
  std::uint8_t* side;    // the longer one before it was clamped, to the nearest pixel, at most 255
};

// A sample is as large as the box around what its own pixel is from there, or a pixel where factor is 0; its sides are clamped to [least,
// most], px, and those with more than `cut_above` are counted.
struct SplatSides {
  float factor, least, most, cut_above;
  WarpedPoint down;  // as WarpBlock::right, a pixel down
};

struct BlockCounts {
  std::uint64_t behind = 0, beside = 0, cut = 0;
};

struct WarpKernels {
  // Each sample into the pixel that it is in, or `margin` (0 or 1) beside the picture; the greater key stays.
  void (*points)(const WarpBlock& block, int margin, const KeyCanvas& canvas, BlockCounts& counts);

  // Whole vectors are written.
  void (*boxes)(const WarpBlock& block, const SplatSides& sides, int width, int height,
                const SampleBoxes& boxes, BlockCounts& counts);

  // A row of the picture from rows of canvases, which are those at its left edge, the margin included: the greatest key of each
  // pixel or, widened, of it and those on both sides. `scratch` has room for a canvas's row.
  void (*finish_row)(std::span<const SampleKey* const> rows, bool widened, int width,
                     std::uint32_t background, SampleKey* scratch, Rgba8* color, float* depth);
};

const WarpKernels& warp_kernels(Target target);

}  // namespace glassbox::views
