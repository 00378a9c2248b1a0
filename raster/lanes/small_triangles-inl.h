// Draws small triangles into a tile. As many triangles as there are lanes are set up at once; then
// each triangle is drawn quad by quad, over the quads that it may cover.

#if defined(GLASSBOX_SMALL_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SMALL_TRIANGLES_INL_H_
#undef GLASSBOX_SMALL_TRIANGLES_INL_H_
#else
#define GLASSBOX_SMALL_TRIANGLES_INL_H_
#endif

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include <glassbox/raster/lanes/alpha-inl.h>
#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/depth-inl.h>
#include <glassbox/raster/lanes/small_setups-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The members of a tile that drawing needs. They are copied so that the compiler sees that stores
// to pixels do not change them.
struct TilePixels {
  HWY_INLINE explicit TilePixels(TileBuffer& t)
      : tile(t),
        depth(t.depth()),
        seen(reinterpret_cast<std::int32_t*>(t.reference())),
        blocks(&t.block(0)),
        listed(&t.listed(0)),
        blocks_across(std::size_t(t.blocks_across())) {}

  TileBuffer& tile;
  TileDepth* depth;
  std::int32_t* seen;
  TileBlock* blocks;
  BlockTriangles* listed;
  std::size_t blocks_across;
};

// Prepares a block for drawing: stores its pixels if it is plain, and resets the bound of its
// nearest depth. This is done before a quad's data is loaded into registers, because the call of
// fill_block would spill them.
HWY_INLINE void prepare_block(TileBuffer& tile, TileBlock& block, std::size_t index) {
  if (HWY_UNLIKELY(block.plain)) fill_block(tile, index);
  block.nearest = kNearestTileDepth;
}

// Adds the triangle to the block's list, unless it is the last entry already.
HWY_INLINE void list_triangle(TileBlock& block, BlockTriangles& list, Reference reference) {
  const std::uint32_t last = block.listed;
  const std::uint32_t at =
      std::min(last + (list.references[last] != reference ? 1u : 0u), BlockTriangles::kTooMany);
  list.references[at] = reference;
  block.listed = at;
}

// Adds triangle t of the batch to the block's list. A tiny triangle (SmallSetups::is_tiny) is not
// added; instead the list is marked as too long.
HWY_INLINE void list_triangle(const SmallSetups& setups, std::size_t t, std::size_t block,
                              const TilePixels& pixels) {
  if (setups.is_tiny[t] != 0) {
    pixels.blocks[block].listed = BlockTriangles::kTooMany;
  } else {
    list_triangle(pixels.blocks[block], pixels.listed[block], Reference(setups.reference[t]));
  }
}

// Triangle t of the batch, in all lanes.
struct SmallTriangleInLanes {
  HWY_INLINE SmallTriangleInLanes(const SmallSetups& s, std::size_t t)
      : slopes1(s.slopes1[t]),
        slopes2(s.slopes2[t]),
        area(s.area[t]),
        above0(s.above0[t]),
        above1(s.above1[t]),
        above2(s.above2[t]),
        reference(s.reference[t]),
        first1(s.e1[t]),
        first2(s.e2[t]),
        inverse_area(s.inverse_area[t]),
        depth0(s.depth0[t]),
        depth1(s.depth1[t]),
        depth2(s.depth2[t]) {}

  Ints slopes1, slopes2, area, above0, above1, above2, reference;
  Ints first1, first2;  // edge functions at the first pixel of the first quad
  Floats inverse_area, depth0, depth1, depth2;
};

// Counts pixels: in each lane separately on processors where a mask is a vector. (The 32 bits of a
// lane are enough: 8192 triangles of 289 quads with 16 samples give less than 2^27.)
struct LaneCounter {
  HWY_INLINE LaneCounter() : lanes(0) {}
  HWY_INLINE void add(IntMask pixels) {
#if HWY_TARGET == HWY_AVX2
    lanes = lanes - Ints(hn::VecFromMask(kI, pixels.m));
#else
    count += count_of(pixels);
#endif
  }
  std::uint64_t total() const {
    HWY_ALIGN std::int32_t of_lanes[kLanes];
    store(lanes, of_lanes);
    return std::accumulate(of_lanes, of_lanes + kLanes, count);
  }

  std::uint64_t count = 0;
  Ints lanes;
};
struct SmallCounts {
  HWY_INLINE SmallCounts() {}
  LaneCounter covered, written;
  FragmentCounts others;
};

// Draws triangle t over one quad: column x, row y of the quads that the triangle's box touches.
template <bool kPartlyOffScreen, class Code, class Alpha>
HWY_INLINE void draw_quad(const SmallSetups& setups, std::size_t t, std::size_t x, std::size_t y,
                          const Code& code_of, const Alpha& alpha, const TilePixels& pixels,
                          SmallCounts& counts) {
  const PixelRect& window = pixels.tile.window();
  const auto qx = std::size_t(setups.x0[t]) + x, qy = std::size_t(setups.y0[t]) + y;
  const std::size_t block = qy / 2 * pixels.blocks_across + qx / 2;
  const std::size_t quad = block * kBlockPixels + ((qy % 2) * 2 + qx % 2) * kQuadPixels;
  prepare_block(pixels.tile, pixels.blocks[block], block);
  list_triangle(setups, t, block, pixels);
  const auto first_pixel = std::int32_t(x * kQuadSide | y * kQuadSide << 16);
  for (std::size_t k = 0; k < kQuadVectors; ++k) {
    const SmallTriangleInLanes s(setups, t);
    const Ints pixel = pair_of(quad_columns(k * kLanes), quad_rows(k * kLanes)) + first_pixel;
    const Ints e1 = s.first1 + shifted_left<kSubpixelBits>(sum_of_products(s.slopes1, pixel));
    const Ints e2 = s.first2 + shifted_left<kSubpixelBits>(sum_of_products(s.slopes2, pixel));
    const Ints e0 = s.area - e1 - e2;
    const Ints above0 = s.above0, above1 = s.above1, above2 = s.above2;
    IntMask covered = e1 > above1 && e2 > above2 && e0 > above0;
    if (kPartlyOffScreen) {
      covered = covered && on_screen(window, window.x0 + int(qx) * kQuadSide,
                                     window.y0 + int(qy) * kQuadSide, k * kLanes);
    }
    const Ints code = code_of(interpolate(s.depth0, s.depth1, s.depth2,
                                          screen_weight(to_float(e1), s.inverse_area),
                                          screen_weight(to_float(e2), s.inverse_area)));
    TileDepth* depth_at_quad = pixels.depth + quad + k * kLanes;
    const Ints stored = load(depth_at_quad);
    IntMask passes = covered && code < stored;
    counts.covered.add(covered);
    if constexpr (Alpha::kIsBehind) {
      passes = passes && alpha.behind(code, window.x0 + int(qx) * kQuadSide,
                                      window.y0 + int(qy) * kQuadSide, k * kLanes);
    }
    if constexpr (!Alpha::kKeepsAll) {
      if (none(passes)) continue;
      const IntMask kept =
          alpha.kept(passes, Reference(setups.reference[t]), window.x0 + int(qx) * kQuadSide,
                     window.y0 + int(qy) * kQuadSide, k * kLanes);
      counts.others.*Alpha::kOthers += count_of(passes) - count_of(kept);
      passes = kept;
    }
    store(select(passes, code, stored), depth_at_quad);
    store_where(passes, s.reference, pixels.seen + quad + k * kLanes);
    counts.written.add(passes);
  }
}

// The tiles for the samples of the same pixels. Only the first tile's blocks list the triangles,
// for all samples.
struct TileSamples {
  HWY_INLINE explicit TileSamples(std::span<TileBuffer> of) : tiles(of), front(of.front()) {
    for (std::size_t s = 0; s < tiles.size(); ++s) {
      TileBuffer& tile = tiles[s];
      samples[s] = {tile.depth(), reinterpret_cast<std::int32_t*>(tile.reference()), &tile.block(0),
                    (tile.point().x & 0xffff) | std::int32_t(unsigned(tile.point().y) << 16)};
    }
  }

  struct Sample {
    TileDepth* depth;
    std::int32_t* seen;
    TileBlock* blocks;
    std::int32_t point;  // its offset, x and y as a pair (pair_of())
  };
  std::span<TileBuffer> tiles;
  TilePixels front;
  Sample samples[kMaxSamples];
};

// Draws triangle t over one quad, at all samples of the quad's pixels. The difference of an edge
// function between a pixel's centre and a sample is the same for all pixels.
template <class Code>
HWY_INLINE void draw_quad(const SmallSetups& setups, std::size_t t, std::size_t x, std::size_t y,
                          const Code& code_of, const TileSamples& pixels, SmallCounts& counts) {
  const PixelRect& window = pixels.front.tile.window();
  const auto qx = std::size_t(setups.x0[t]) + x, qy = std::size_t(setups.y0[t]) + y;
  const std::size_t block = qy / 2 * pixels.front.blocks_across + qx / 2;
  const std::size_t quad = block * kBlockPixels + ((qy % 2) * 2 + qx % 2) * kQuadPixels;
  const std::size_t count = pixels.tiles.size();
  for (std::size_t i = 0; i < count; ++i) {
    prepare_block(pixels.tiles[i], pixels.samples[i].blocks[block], block);
  }
  list_triangle(setups, t, block, pixels.front);
  const auto first_pixel = std::int32_t(x * kQuadSide | y * kQuadSide << 16);
  const SmallTriangleInLanes s(setups, t);
  Ints centre1[kQuadVectors], centre2[kQuadVectors];
  IntMask inside[kQuadVectors];
  for (std::size_t k = 0; k < kQuadVectors; ++k) {
    const Ints pixel = pair_of(quad_columns(k * kLanes), quad_rows(k * kLanes)) + first_pixel;
    centre1[k] = s.first1 + shifted_left<kSubpixelBits>(sum_of_products(s.slopes1, pixel));
    centre2[k] = s.first2 + shifted_left<kSubpixelBits>(sum_of_products(s.slopes2, pixel));
    inside[k] = on_screen(window, window.x0 + int(qx) * kQuadSide, window.y0 + int(qy) * kQuadSide,
                          k * kLanes);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const TileSamples::Sample& sample = pixels.samples[i];
    const Ints more1 = sum_of_products(s.slopes1, sample.point);
    const Ints more2 = sum_of_products(s.slopes2, sample.point);
    for (std::size_t k = 0; k < kQuadVectors; ++k) {
      const Ints e1 = centre1[k] + more1, e2 = centre2[k] + more2;
      const Ints e0 = s.area - e1 - e2;
      const IntMask covered = inside[k] && e1 > s.above1 && e2 > s.above2 && e0 > s.above0;
      const Ints code = code_of(interpolate(s.depth0, s.depth1, s.depth2,
                                            screen_weight(to_float(e1), s.inverse_area),
                                            screen_weight(to_float(e2), s.inverse_area)));
      TileDepth* depth_at_quad = sample.depth + quad + k * kLanes;
      const Ints stored = load(depth_at_quad);
      const IntMask passes = code < stored && covered;
      store(select(passes, code, stored), depth_at_quad);
      store_where(passes, s.reference, sample.seen + quad + k * kLanes);
      counts.covered.add(covered);
      counts.written.add(passes);
    }
  }
}

// Calls draw(t, x, y) for the quads of one triangle after the other, in the order of the batch. The
// processor cannot predict how many quads a triangle has, and which ones. So the quads of several
// triangles are the bits of one word, and the only branch that depends on them is the one at the
// end of the word.
template <class Points, class Draw>
HWY_INLINE void for_each_quad(const SmallSetups& s, std::size_t live, const Points& points,
                              const Draw& draw) {
  constexpr std::size_t kSide = kMaskSide, kBits = kSide * kSide, kGroup = 64 / kBits;
  static_assert(kSmallBatch % kGroup == 0);
  const auto draw_quads = [&](std::uint64_t quads, std::size_t t, std::int32_t x,
                              std::int32_t y) HWY_ATTR {
    for (; quads != 0; quads &= quads - 1) {
      const auto bit = std::size_t(std::countr_zero(quads));
      draw(t + bit / kBits, std::size_t(x) + bit % kSide, std::size_t(y) + bit / kSide % kSide);
    }
  };
  for (std::size_t first = 0; first < live; first += kGroup) {
    const std::size_t end = HWY_MIN(first + kGroup, live);
    if (HWY_LIKELY((s.wide >> first & ((1u << kGroup) - 1)) == 0)) {
      std::uint64_t quads;
      std::memcpy(&quads, s.quads + first, sizeof(quads));
      if (end < first + kGroup) quads &= (std::uint64_t{1} << kBits * (end - first)) - 1;
      draw_quads(quads, first, 0, 0);
      continue;
    }
    for (std::size_t t = first; t < end; ++t) {
      for (std::int32_t y = 0; y < s.y1[t] - s.y0[t]; y += kMaskSide) {
        for (std::int32_t x = 0; x < s.x1[t] - s.x0[t]; x += kMaskSide) {
          draw_quads(find_quads_from(points, s, t, x, y), t, x, y);
        }
      }
    }
  }
}

// Sets up and places the triangles batch by batch; draw(setups, t, x, y) is called for their quads.
template <class Points, class Draw>
HWY_INLINE void draw_batches(const SmallJob& job, TriangleNumbers triangles,
                             const PixelRect& window, const Points& points, const Draw& draw) {
  SmallSetups setups;
  for (std::size_t i = 0; i < triangles.size(); i += kSmallBatch) {
    const std::size_t live = HWY_MIN(kSmallBatch, triangles.size() - i);
    for (std::size_t k = 0; k < live; k += kLanes) {
      HWY_ALIGN std::int32_t lanes[kLanes];
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        lanes[lane] = std::int32_t(triangles[i + HWY_MIN(k + lane, live - 1)]);
      }
      set_up(job, load(lanes), window, setups, k);
    }
    for (std::size_t k = 0; k < live; k += kLanes) {
      place_in_tile(window, points, setups, k, first_lanes(live - k));
    }
    for_each_quad(setups, live, points, [&](std::size_t t, std::size_t x, std::size_t y) HWY_ATTR {
      draw(setups, t, x, y);
    });
  }
}

template <bool kPartlyOffScreen, class Code, class Alpha>
HWY_INLINE void draw_all(const SmallJob& job, TriangleNumbers triangles, const Code& code_of,
                         const Alpha& alpha, TileBuffer& tile, SmallCounts& counts) {
  const TilePixels pixels(tile);
  draw_batches(job, triangles, tile.window(), AtOnePoint{tile.point()},
               [&](const SmallSetups& setups, std::size_t t, std::size_t x, std::size_t y)
                   HWY_ATTR {
                     draw_quad<kPartlyOffScreen>(setups, t, x, y, code_of, alpha, pixels, counts);
                   });
}
// Draws the triangles at several samples of each pixel.
template <class Code>
HWY_INLINE void draw_all(const SmallJob& job, TriangleNumbers triangles, const Code& code_of,
                         std::span<TileBuffer> tiles, SmallCounts& counts) {
  const TileSamples pixels(tiles);
  draw_batches(job, triangles, tiles.front().window(), AtSomePoints(tiles),
               [&](const SmallSetups& setups, std::size_t t, std::size_t x, std::size_t y)
                   HWY_ATTR { draw_quad(setups, t, x, y, code_of, pixels, counts); });
}

template <class Alpha>
HWY_INLINE void draw_small(const SmallJob& job, TriangleNumbers triangles, const Alpha& alpha,
                           std::span<TileBuffer> tiles, FragmentCounts& counts) {
  SmallCounts own;
  TileBuffer& tile = tiles.front();
  with_code(tile.format(), [&](const auto& code_of) HWY_ATTR {
    // With an alpha test or samples, testing for the screen's edge costs little in comparison. So
    // one loop is used for tiles within the screen and at its edge; only opaque draws with one
    // point per pixel have two.
    if constexpr (Alpha::kKeepsAll) {
      if (tiles.size() > 1) return draw_all(job, triangles, code_of, tiles, own);
      if (!tile.is_partly_off_screen()) {
        return draw_all<false>(job, triangles, code_of, alpha, tile, own);
      }
    }
    draw_all<true>(job, triangles, code_of, alpha, tile, own);
  });
  counts.covered += own.covered.total();
  counts.written += own.written.total();
  counts.discarded += own.others.discarded;
  counts.blended += own.others.blended;
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
