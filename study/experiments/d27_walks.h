// The ways to visit the pixels of a triangle (D-27).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/lanes/kernels.h>

#include "study/experiments/random_triangles.h"

namespace glassbox::study::d27 {

inline constexpr PixelRect kWindow{0, 0, kShapesSide, kShapesSide};
using Counts = Image<std::uint16_t>;  // how many triangles cover each pixel
using Triangles = std::vector<TriangleSetup>;

inline std::int64_t value_at(const EdgeFunction& edge, int x, int y) {
  return edge.at(std::int64_t(x) * kSubpixels + kPixelCentre,
                 std::int64_t(y) * kSubpixels + kPixelCentre);
}

// The smallest value of the edge function at which a pixel counts as covered.
inline std::int64_t least(const EdgeFunction& edge) {
  return edge.owns_zero ? 0 : 1;
}

// ---- the methods ----

// Tests all three edges from scratch for every pixel of the box.
inline void walk_box(const TriangleSetup& t, Counts& counts) {
  const PixelRect box = intersect(t.bounds, kWindow);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      if (std::ranges::all_of(t.edges,
                              [&](const EdgeFunction& e) { return e.covers(value_at(e, x, y)); }))
        ++counts.at(x, y);
    }
  }
}

// Uses the coverage of the pipeline's staged engine: one addition per edge for each pixel of the
// box.
inline void walk_incrementally(const TriangleSetup& t, Counts& counts) {
  for_each_covered(t, kWindow, [&](const Coverage& pixel) { ++counts.at(pixel.x, pixel.y); });
}

inline std::int64_t floor_div(std::int64_t a, std::int64_t b) {  // b must be > 0
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// Draws one span per row, whose ends are found by exact integer division.
inline void walk_rows(const TriangleSetup& t, Counts& counts) {
  const PixelRect box = intersect(t.bounds, kWindow);
  for (int y = box.y0; y < box.y1; ++y) {
    std::int64_t x0 = box.x0, x1 = box.x1;
    for (const EdgeFunction& e : t.edges) {
      // For this edge, pixel x is inside if first + step x >= 0.
      const std::int64_t first = value_at(e, 0, y) - least(e), step = e.a * kSubpixels;
      if (step > 0) x0 = std::max(x0, floor_div(-first + step - 1, step));
      if (step < 0) x1 = std::min(x1, floor_div(first, -step) + 1);
      if (step == 0 && first < 0) x1 = x0;
    }
    for (std::int64_t x = x0; x < x1; ++x) ++counts.at(int(x), y);
  }
}

// Blocks of 8 x 8 pixels are rejected, accepted as a whole, or tested pixel by pixel. The extremes
// of an edge function over a block are at its corners.
inline void walk_blocks(const TriangleSetup& t, Counts& counts) {
  constexpr int kSide = 8;
  const PixelRect box = intersect(t.bounds, kWindow);
  for (int by = box.y0 / kSide * kSide; by < box.y1; by += kSide) {
    for (int bx = box.x0 / kSide * kSide; bx < box.x1; bx += kSide) {
      bool outside = false, inside = true;
      for (const EdgeFunction& e : t.edges) {
        const std::int64_t first = value_at(e, bx, by) - least(e);
        const std::int64_t right = e.a * kSubpixels * (kSide - 1),
                           down = e.b * kSubpixels * (kSide - 1);
        outside = outside ||
                  first + std::max<std::int64_t>(right, 0) + std::max<std::int64_t>(down, 0) < 0;
        inside = inside &&
                 first + std::min<std::int64_t>(right, 0) + std::min<std::int64_t>(down, 0) >= 0;
      }
      if (outside) continue;
      const PixelRect block = intersect({bx, by, bx + kSide, by + kSide}, box);
      if (inside) {
        for (int y = block.y0; y < block.y1; ++y) {
          for (int x = block.x0; x < block.x1; ++x) ++counts.at(x, y);
        }
      } else {
        for_each_covered(t, block, [&](const Coverage& pixel) { ++counts.at(pixel.x, pixel.y); });
      }
    }
  }
}

using Walk = void (*)(const TriangleSetup&, Counts&);
struct NamedWalk {
  const char* name;
  Walk walk;
};
inline constexpr NamedWalk kTraversals[] = {{"whole box, edges computed for each pixel", walk_box},
                                            {"whole box, incremental", walk_incrementally},
                                            {"scan lines", walk_rows},
                                            {"8x8 blocks", walk_blocks}};

// ---- the tile engine's kernel ----

// Draws into one tile as large as the window; the depth buffer of the tile shows which pixels a
// triangle covers.
inline void draw_over_lanes(const TriangleSetup& t, Reference reference, TileBuffer& tile) {
  static const Kernels& best = kernels(best_target());
  FragmentCounts ignored;
  best.draw_large(t, reference, tile, ignored);
}

inline void count_over_lanes(const TriangleSetup& t, TileBuffer& tile, Counts& counts) {
  constexpr Reference kDrawn = kLargeReference;
  tile.clear(kWindow, DepthFormat::kFloat32);
  draw_over_lanes(t, kDrawn, tile);
  for (int y = 0; y < kShapesSide; ++y) {
    for (int x = 0; x < kShapesSide; ++x) {
      const TileBlock& block = tile.block(tile.block_index(x / kBlockSide, y / kBlockSide));
      const Reference seen =
          block.plain ? block.reference : tile.reference()[tile.pixel_index(x, y)];
      counts.at(x, y) = std::uint16_t(counts.at(x, y) + (seen == kDrawn));
    }
  }
}

}  // namespace glassbox::study::d27
