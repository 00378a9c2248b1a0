// The inner loops of drawing layers, compiled once for each instruction set. They use integers, and
// floats in the order of operations that the code states, so that the result has the same bytes for
// every instruction set.
#pragma once

#include <cstdint>
#include <span>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The content of a pixel of a canvas: the bits of the depth in the upper half, and those of the
// colour in the lower half. The bits of a positive float ascend as its value does, so the greater
// of two keys is the nearer sample; of two with the same depth, it is the one whose colour is the
// greater number. 0: a hole.
using SampleKey = std::uint64_t;

// The greatest depth that is drawn: the near plane's 1, and room for rounding. For a sample on the
// near plane, z w and w each have up to four roundings (a coefficient, a product, two sums), and
// 1/w and the last product have one each: 10 u with the unit roundoff u = 2^-24. The constant
// allows 16 u.
inline constexpr float kNearestDepth = 1 + 0x1p-20f;

struct WarpedPoint {
  float x, y, z, w;  // x, y and z are multiplied by w
};

// Samples of one row, from pixels at most 64 columns apart.
struct WarpBlock {
  // Whole vectors are read: there must be 64 readable bytes beyond the last number.
  const float* depth;
  const std::uint32_t* color;
  const std::uint16_t* column;
  // The change of the surface's depth for a step of one pixel to the right and one pixel down.
  const float *slope_x, *slope_y;
  int count;
  int anchor;  // the column that `start` belongs to
  // A sample is at start + (column - anchor) right + its depth * depth_step.
  WarpedPoint start, right, depth_step;
};

// A picture of keys with one more pixel on each side, so that splats of 3 x 3 pixels may have their
// centre there.
struct KeyCanvas {
  SampleKey* keys;    // begins at pixel (-1, -1)
  int width, height;  // of the picture
  int stride() const { return width + 2; }
  // The index behind the last pixel: samples that are not drawn are written there.
  int discard_index() const { return stride() * (height + 2); }
};

// The boxes of pixels that the samples' splats cover, [left, right) x [top, bottom); empty for a
// sample that is not drawn.
struct SampleBoxes {
  std::int32_t *left, *top, *right, *bottom;
  std::uint32_t* depth;  // bits of the depth
  // The box's longer side before it was clamped, rounded to whole pixels, at most 255.
  std::uint8_t* side;
};

// A sample's splat is the box around the projection of its own pixel (factor 1), or a box of fixed
// size (factor 0). Its sides are clamped to [least, most], px, and samples whose longer side was
// above `oversized_above` before that are counted.
struct SplatSides {
  float factor, least, most, oversized_above;
  WarpedPoint down;  // like WarpBlock::right, but for a step of one pixel down
};

struct BlockCounts {
  std::uint64_t behind = 0, outside = 0, oversized = 0;
};

struct WarpKernels {
  // Draws each sample into the pixel that it is in, or up to `margin` (0 or 1) pixels outside of
  // the picture; the greater key stays.
  void (*points)(const WarpBlock& block, int margin, const KeyCanvas& canvas, BlockCounts& counts);

  // Computes the boxes of the block's samples. Whole vectors are written, so the arrays need
  // padding.
  void (*boxes)(const WarpBlock& block, const SplatSides& sides, int width, int height,
                const SampleBoxes& boxes, BlockCounts& counts);

  // Makes a row of the picture from rows of all canvases. Each of `rows` begins at its canvas's
  // left edge, margin included. The picture shows the greatest key of each pixel or, if `widened`,
  // of the pixel and its neighbours to the left and right. `scratch` has room for a canvas's row.
  void (*finish_row)(std::span<const SampleKey* const> rows, bool widened, int width,
                     std::uint32_t background, SampleKey* scratch, Rgba8* color, float* depth);
};

const WarpKernels& warp_kernels(Target target);

}  // namespace glassbox::views
