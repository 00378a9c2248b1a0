// Draws large triangles into a tile, block by block. Most blocks are skipped or covered as a whole;
// single pixels are tested only along the edges, and where something else may be in front.

#if defined(GLASSBOX_LARGE_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_LARGE_TRIANGLES_INL_H_
#undef GLASSBOX_LARGE_TRIANGLES_INL_H_
#else
#define GLASSBOX_LARGE_TRIANGLES_INL_H_
#endif

#include <algorithm>

#include <glassbox/raster/lanes/alpha-inl.h>
#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/small_triangles-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The range that contains the depth codes of a triangle's pixels.
struct CodeRange {
  TileDepth nearest = 0, farthest = 0;
};

// depth[0] is the smallest of the vertices' depths, and no pixel's depth is smaller
// (formulas/interpolate.h). Because of rounding, a pixel's depth may exceed the largest one: by
// less than 2^-20 of it (four roundings of lambda and four operations), and by half of the smallest
// float for each product that is subnormal.
inline CodeRange code_range(const TriangleSetup& setup, DepthFormat format) {
  const float least = setup.depth[0];
  const float largest = std::max({setup.depth[0], setup.depth[1], setup.depth[2]});
  const float greatest =
      least == largest ? largest : largest + (std::abs(largest) * 0x1p-20f + 0x1p-148f);
  const auto low = TileDepth(depth_code(format, least));
  const auto high = TileDepth(depth_code(format, greatest));
  return {std::min(low, high), std::max(low, high)};
}

struct LargeEdge {
  EdgeFunction edge;
  std::int64_t least = 0;  // a point with a smaller value is outside
  // Multiplied by side - 1: how far the smallest value in a square of `side` pixels is below the
  // value at its first pixel (a number <= 0), and how far the largest is above it.
  std::int64_t below = 0, above = 0;
  Doubles offsets[kQuadVectors];
};

template <int kEdge>
HWY_INLINE LargeEdge large_edge(const TriangleSetup& setup) {
  LargeEdge e;
  e.edge = setup.edges[kEdge];
  e.least = least_inside(e.edge);
  const std::int64_t right = e.edge.a * kSubpixels, down = e.edge.b * kSubpixels;
  e.below = std::min<std::int64_t>(right, 0) + std::min<std::int64_t>(down, 0);
  e.above = std::max<std::int64_t>(right, 0) + std::max<std::int64_t>(down, 0);
  for (std::size_t k = 0; k < kQuadVectors; ++k)
    e.offsets[k] = quad_offsets<kEdge>(setup, k * kLanes);
  return e;
}

// Draws one large triangle. `shape` is null if the tile keeps all fragments, because then it is not
// used.
template <class Code, class Alpha>
class LargeRaster {
public:
  HWY_INLINE LargeRaster(const TriangleSetup& setup, const LargeShape* shape,
                         const CodeRange& codes, Reference reference, const Code& code_of,
                         const Alpha& alpha, TileBuffer& tile, FragmentCounts& counts)
      : setup_(setup),
        shape_(shape),
        reference_(reference),
        code_of_(code_of),
        alpha_(alpha),
        tile_(tile),
        point_(tile.point()),
        counts_(counts),
        edges_{large_edge<0>(setup), large_edge<1>(setup), large_edge<2>(setup)},
        depth_(setup),
        codes_(codes) {}

  HWY_INLINE void draw() {
    const PixelRect& window = tile_.window();
    const PixelRect box = intersect(pixels_reached(), window);
    if (box.empty()) return;
    const Overlap tile_overlap = overlap_of(window.x0, window.y0, tile_.side());
    if (tile_overlap == Overlap::kOutside) return;
    const int first_x = (box.x0 - window.x0) / kBlockSide,
              last_x = (box.x1 - 1 - window.x0) / kBlockSide;
    const int first_y = (box.y0 - window.y0) / kBlockSide,
              last_y = (box.y1 - 1 - window.y0) / kBlockSide;
    for (int by = first_y; by <= last_y; ++by) {
      for (int bx = first_x; bx <= last_x; ++bx) draw_block(bx, by, tile_overlap);
    }
    if (fills(tile_overlap)) tile_.lower_farthest(codes_.farthest);
  }

private:
  enum class Overlap { kOutside, kCrossed, kInside };

  HWY_INLINE PixelRect pixels_reached() const {
    const bool at_centres = point_.x == 0 && point_.y == 0;
    return at_centres ? setup_.bounds : sampled_bounds(setup_.bounds);
  }

  // Whether every pixel of the square is covered and no fragment is discarded.
  HWY_INLINE static bool fills(Overlap overlap) {
    return Alpha::kKeepsAll && overlap == Overlap::kInside;
  }

  // Classifies the square of `side` pixels at (x, y): the extremes of an edge function over it are
  // at its corners.
  HWY_INLINE Overlap overlap_of(int x, int y, int side) const {
    bool inside = true;
    for (const LargeEdge& e : edges_) {
      const std::int64_t first = edge_in_pixel(e.edge, x, y, point_);
      if (first + e.above * (side - 1) < e.least) return Overlap::kOutside;
      inside = inside && first + e.below * (side - 1) >= e.least;
    }
    return inside ? Overlap::kInside : Overlap::kCrossed;
  }

  HWY_INLINE void draw_block(int bx, int by, Overlap tile_overlap) {
    const PixelRect& window = tile_.window();
    const int x = window.x0 + bx * kBlockSide, y = window.y0 + by * kBlockSide;
    const std::size_t index = tile_.block_index(bx, by);
    TileBlock& block = tile_.block(index);
    if (codes_.nearest >= block.farthest) {
      ++counts_.hidden_blocks;
      return;
    }
    const Overlap overlap =
        tile_overlap == Overlap::kInside ? tile_overlap : overlap_of(x, y, kBlockSide);
    if (overlap == Overlap::kOutside) return;
    const bool whole =
        overlap == Overlap::kInside && x + kBlockSide <= window.x1 && y + kBlockSide <= window.y1;
    if (whole && fills(overlap) && codes_.farthest < block.nearest) {
      block = {codes_.nearest, codes_.farthest, true, reference_,
               codes_.nearest == codes_.farthest ? nullptr : &setup_};
      counts_.covered += kBlockPixels;
      counts_.written += kBlockPixels;
      return;
    }
    make_plain_block_full(tile_, index);
    const std::uint64_t written_before = counts_.written;
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      draw_quad(index, quad, x + (quad % 2) * kQuadSide, y + (quad / 2) * kQuadSide, whole);
    }
    block.nearest = std::min(block.nearest, codes_.nearest);
    if (whole && fills(overlap)) block.farthest = std::min(block.farthest, codes_.farthest);
    // Several triangles may cover the block together, though none of them covers it alone. So if no
    // pixel of this triangle was written, the farthest depth is computed from the pixels: the next
    // triangles are likely to be hidden, too, and can then be skipped.
    if (counts_.written == written_before) {
      block.farthest = std::min(block.farthest, farthest_in(index));
    }
  }

  HWY_INLINE TileDepth farthest_in(std::size_t block) const {
    const TileDepth* depth = tile_.depth() + block * kBlockPixels;
    Ints farthest = load(depth);
    for (std::size_t i = kLanes; i < kBlockPixels; i += kLanes) {
      farthest = greatest(farthest, load(depth + i));
    }
    return hn::GetLane(hn::MaxOfLanes(kI, farthest.v));
  }

  HWY_INLINE void draw_quad(std::size_t block, int quad, int x, int y, bool whole) {
    const double first0 = edge_at_pixel(edges_[0].edge, x, y, point_);
    const double first1 = edge_at_pixel(edges_[1].edge, x, y, point_);
    const double first2 = edge_at_pixel(edges_[2].edge, x, y, point_);
    const std::size_t at = block * kBlockPixels + std::size_t(quad * kQuadPixels);
    for (std::size_t k = 0; k < kQuadVectors; ++k) {
      const Doubles e1 = edges_[1].offsets[k] + first1;
      const Doubles e2 = edges_[2].offsets[k] + first2;
      IntMask covered = first_lanes(kLanes);
      if (!whole) {
        covered = covers(edges_[0].offsets[k] + first0, edges_[0].least) &&
                  covers(e1, edges_[1].least) && covers(e2, edges_[2].least);
        if (tile_.is_partly_off_screen())
          covered = covered && on_screen(tile_.window(), x, y, k * kLanes);
        if (none(covered)) continue;
      }
      const Ints code = code_of_(depth_.at(e1, e2));
      TileDepth* depth = tile_.depth() + at + k * kLanes;
      auto* seen = reinterpret_cast<std::int32_t*>(tile_.reference() + at) + k * kLanes;
      const Ints stored = load(depth);
      IntMask passes = covered && code < stored;
      counts_.covered += count_of(covered);
      if constexpr (Alpha::kIsBehind) passes = passes && alpha_.behind(code, x, y, k * kLanes);
      if constexpr (!Alpha::kKeepsAll) {
        if (none(passes)) continue;
        const IntMask kept = alpha_.kept(passes, *shape_, x, y, k * kLanes);
        counts_.*Alpha::kOthers += count_of(passes) - count_of(kept);
        passes = kept;
      }
      store(select(passes, code, stored), depth);
      store(select(passes, std::int32_t(reference_), load(seen)), seen);
      counts_.written += count_of(passes);
    }
  }

  const TriangleSetup& setup_;
  const LargeShape* shape_;
  Reference reference_;
  const Code& code_of_;
  const Alpha& alpha_;
  TileBuffer& tile_;
  SampleOffset point_;
  FragmentCounts& counts_;
  LargeEdge edges_[3];
  LargeDepth depth_;
  CodeRange codes_;
};

template <class Alpha>
HWY_INLINE void draw_large(const TriangleSetup& setup, const LargeShape* shape, Reference reference,
                           const Alpha& alpha, TileBuffer& tile, FragmentCounts& counts) {
  const CodeRange codes = code_range(setup, tile.format());
  if (codes.nearest >= tile.farthest()) {
    counts.hidden_blocks += tile.block_count();
    return;
  }
  with_code(tile.format(), [&](const auto& code_of) HWY_ATTR {
    LargeRaster(setup, shape, codes, reference, code_of, alpha, tile, counts).draw();
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
