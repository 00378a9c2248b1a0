// Computes edge functions and depths of large triangles over the pixels of a block. Also stores the
// pixels of a plain block (TileBlock::plain: its pixels are not stored) when they are needed.

#if defined(GLASSBOX_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_BLOCKS_INL_H_
#undef GLASSBOX_BLOCKS_INL_H_
#else
#define GLASSBOX_BLOCKS_INL_H_
#endif

#include <glassbox/raster/lanes/depth-inl.h>
#include <glassbox/raster/lanes/quads-inl.h>
#include <glassbox/raster/lanes/tables.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Edge functions are integers of at most 52 bits, which doubles represent exactly.
//
// Returns the differences of a large triangle's edge function between a quad's first pixel and
// pixels i .. i + kLanes - 1.
template <int kEdge>
HWY_INLINE Doubles quad_offsets(const TriangleSetup& setup, std::size_t i) {
  const EdgeFunction& edge = setup.edges[kEdge];
  return widened(to_float(quad_columns(i))) * double(edge.a * kSubpixels) +
         widened(to_float(quad_rows(i))) * double(edge.b * kSubpixels);
}

// An edge function at a pixel of the screen, at its centre or at another point of it.
HWY_INLINE std::int64_t edge_in_pixel(const EdgeFunction& edge, int x, int y, SampleOffset point) {
  return edge.at(std::int64_t(x) * kSubpixels + kPixelCentre + point.x,
                 std::int64_t(y) * kSubpixels + kPixelCentre + point.y);
}
HWY_INLINE double edge_at_pixel(const EdgeFunction& edge, int x, int y, SampleOffset point = {}) {
  return double(edge_in_pixel(edge, x, y, point));
}

// The smallest value of an edge function at points that the triangle covers.
HWY_INLINE std::int64_t least_inside(const EdgeFunction& edge) {
  return edge.owns_zero ? 0 : 1;
}
HWY_INLINE IntMask covers(const Doubles& values, std::int64_t least) {
  // `least` is 0 or 1, which a float represents exactly, and rounding an integer to float keeps its
  // sign.
  return int_mask(rounded(values) >= float(least));
}

// Computes a large triangle's depth at pixels from two of its edge functions there.
struct LargeDepth {
  explicit LargeDepth(const TriangleSetup& triangle)
      : setup(triangle),
        inverse_area(triangle.inverse_area),
        depth0(triangle.depth[0]),
        depth1(triangle.depth[1] - triangle.depth[0]),
        depth2(triangle.depth[2] - triangle.depth[0]) {}

  HWY_INLINE Floats at(const Doubles& e1, const Doubles& e2) const {
    return interpolate(depth0, depth1, depth2, screen_weight(rounded(e1), inverse_area),
                       screen_weight(rounded(e2), inverse_area));
  }

  const TriangleSetup& setup;
  Floats inverse_area, depth0, depth1, depth2;
};

// Writes the depth codes of a quad's pixels to `codes`.
inline void fill_quad_depths(const TriangleSetup& setup, const TileBuffer& tile, int x, int y,
                             std::int32_t* codes) {
  const LargeDepth depth(setup);
  const double first1 = edge_at_pixel(setup.edges[1], x, y, tile.point());
  const double first2 = edge_at_pixel(setup.edges[2], x, y, tile.point());
  with_code(tile.format(), [&](const auto& code_of) HWY_ATTR {
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      store(
          code_of(depth.at(quad_offsets<1>(setup, k) + first1, quad_offsets<2>(setup, k) + first2)),
          codes + k);
    }
  });
}

inline void fill_block_depths(const TriangleSetup& setup, TileBuffer& tile, std::size_t block) {
  const int x = tile.window().x0 + int(block % std::size_t(tile.blocks_across())) * kBlockSide;
  const int y = tile.window().y0 + int(block / std::size_t(tile.blocks_across())) * kBlockSide;
  for (int quad = 0; quad < kBlockQuads; ++quad) {
    fill_quad_depths(setup, tile, x + (quad % 2) * kQuadSide, y + (quad / 2) * kQuadSide,
                     tile.depth() + block * kBlockPixels + std::size_t(quad * kQuadPixels));
  }
}

inline void fill_block(TileBuffer& tile, std::size_t index) {
  TileBlock& block = tile.block(index);
  block.plain = false;
  auto* seen = reinterpret_cast<std::int32_t*>(tile.reference() + index * kBlockPixels);
  for (std::size_t i = 0; i < kBlockPixels; i += kLanes) {
    store(std::int32_t(block.reference), seen + i);
  }
  if (block.triangle == nullptr) {
    for (std::size_t i = 0; i < kBlockPixels; i += kLanes) {
      store(block.nearest, tile.depth() + index * kBlockPixels + i);
    }
  } else {
    fill_block_depths(*block.triangle, tile, index);
  }
}

// Makes sure that depths and references of a block's pixels are stored: stores them if the block is
// plain.
HWY_INLINE void make_plain_block_full(TileBuffer& tile, std::size_t index) {
  if (HWY_UNLIKELY(tile.block(index).plain)) fill_block(tile, index);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
