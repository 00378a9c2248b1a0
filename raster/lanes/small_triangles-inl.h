// Small triangles into a tile: as many as there are lanes are set up at once; then each is tested against the quads of pixels
// that its box meets, a quad at a time.

#if defined(GLASSBOX_SMALL_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SMALL_TRIANGLES_INL_H_
#undef GLASSBOX_SMALL_TRIANGLES_INL_H_
#else
#define GLASSBOX_SMALL_TRIANGLES_INL_H_
#endif

#include <glassbox/raster/lanes/alpha-inl.h>
#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/depth-inl.h>
#include <glassbox/raster/lanes/select-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Triangles are set up so many at a time: the tables' lines are then on their way for all of them before the first is drawn.
inline constexpr std::size_t kSmallBatch = 64;

// A batch of small triangles, set up: one column a triangle. Edges 1 and 2 are kept; edge 0 is what they leave of the area.
struct SmallSetups {
  template <class T>
  using Row = T[kSmallBatch];

  HWY_ALIGN Row<std::int32_t> reference;
  HWY_ALIGN Row<std::int32_t> right1, right2;  // what a step of one pixel adds
  HWY_ALIGN Row<std::int32_t> down1, down2;
  HWY_ALIGN Row<std::int32_t> above0, above1, above2;
  HWY_ALIGN Row<std::int32_t> area;
  HWY_ALIGN Row<float> inverse_area;
  HWY_ALIGN Row<float> depth0, depth1, depth2;           // 1 and 2 less 0
  HWY_ALIGN Row<std::int32_t> left, top, right, bottom;  // of the box
  HWY_ALIGN Row<std::int32_t> origin1, origin2;  // edges at the centre of the tile's first pixel

  // Where the triangle begins, for the point of a pixel that a tile asks at.
  HWY_ALIGN Row<std::int32_t> x0, y0, x1, y1;  // quads of the tile, x1 and y1 excluded
  HWY_ALIGN Row<std::int32_t> e1, e2;          // at the first pixel of the first quad
};

HWY_INLINE void set_up(const SmallJob& job, Ints triangle, const PixelRect& window, SmallSetups& to,
                       std::size_t at) {
  const OfVertices<Ints> vertices = gather_indices(job.positions, triangle);
  const OfVertices<Ints> entries = entries_of(vertices);
  OfVertices<Ints> x, y;
  gather_position(job.screen, entries, x, y);
  OfVertices<Floats> z = gather(&job.screen->z, entries);
  const Ints signed_area = double_area(x, y);
  const Order order = order_of(signed_area, z);
  x = put_in_order(order, x);
  y = put_in_order(order, y);
  z = put_in_order(order, z);
  const Ints area = abs(signed_area);
  store(std::int32_t(job.first_reference) +
            (triangle * std::int32_t(kReferenceStep) | code_of(order)),
        to.reference + at);

  store(smallest(x), to.left + at);
  store(smallest(y), to.top + at);
  store(largest(x), to.right + at);
  store(largest(y), to.bottom + at);

  const Ints at_x = window.x0 * kSubpixels + kPixelCentre;
  const Ints at_y = window.y0 * kSubpixels + kPixelCentre;
  const EdgeSlopes<Ints> edge0 = edge_of<0>(x, y), edge1 = edge_of<1>(x, y),
                         edge2 = edge_of<2>(x, y);
  store(value_of<1>(edge1, x, y, at_x, at_y), to.origin1 + at);
  store(value_of<2>(edge2, x, y, at_x, at_y), to.origin2 + at);
  store(shifted_left<kSubpixelBits>(edge1.a), to.right1 + at);
  store(shifted_left<kSubpixelBits>(edge2.a), to.right2 + at);
  store(shifted_left<kSubpixelBits>(edge1.b), to.down1 + at);
  store(shifted_left<kSubpixelBits>(edge2.b), to.down2 + at);
  store(outside_up_to(edge0), to.above0 + at);
  store(outside_up_to(edge1), to.above1 + at);
  store(outside_up_to(edge2), to.above2 + at);
  store(area, to.area + at);
  store(1.0f / to_float(area), to.inverse_area + at);
  store(z[0], to.depth0 + at);
  store(z[1] - z[0], to.depth1 + at);
  store(z[2] - z[0], to.depth2 + at);
}

// Where kLanes triangles begin in the tile. (An edge at the tile's first pixel may not fit 32 bits; at the triangle's own pixels it
// does, and sums that wrap around arrive there all the same.)
HWY_INLINE void place(const TileBuffer& tile, SmallSetups& s, std::size_t at) {
  const PixelRect& window = tile.window();
  const SampleOffset point = tile.point();
  const Ints px0 = greatest(first_pixel(load(s.left + at) - point.x), Ints(window.x0)) - window.x0;
  const Ints py0 = greatest(first_pixel(load(s.top + at) - point.y), Ints(window.y0)) - window.y0;
  const Ints px1 = least(end_pixel(load(s.right + at) - point.x), Ints(window.x1)) - window.x0;
  const Ints py1 = least(end_pixel(load(s.bottom + at) - point.y), Ints(window.y1)) - window.y0;
  const Ints qx0 = shifted_right<2>(px0), qy0 = shifted_right<2>(py0);
  store(qx0, s.x0 + at);
  store(qy0, s.y0 + at);
  store(shifted_right<2>(px1 + 3), s.x1 + at);
  store(shifted_right<2>(py1 + 3), s.y1 + at);

  const Ints dx = shifted_left<2 + kSubpixelBits>(qx0) + point.x;
  const Ints dy = shifted_left<2 + kSubpixelBits>(qy0) + point.y;
  const auto edge_at = [&](const std::int32_t* origin, const std::int32_t* right,
                           const std::int32_t* down) HWY_ATTR {
    return load(origin + at) + shifted_right<kSubpixelBits>(load(right + at)) * dx +
           shifted_right<kSubpixelBits>(load(down + at)) * dy;
  };
  store(edge_at(s.origin1, s.right1, s.down1), s.e1 + at);
  store(edge_at(s.origin2, s.right2, s.down2), s.e2 + at);
}

// What drawing into a tile needs of it, held where the compiler sees that stores to pixels leave it alone.
struct TilePixels {
  HWY_INLINE explicit TilePixels(TileBuffer& t)
      : tile(t),
        depth(t.depth()),
        seen(reinterpret_cast<std::int32_t*>(t.reference())),
        blocks(&t.block(0)),
        blocks_across(std::size_t(t.blocks_across())) {}

  TileBuffer& tile;
  TileDepth* depth;
  std::int32_t* seen;
  TileBlock* blocks;
  std::size_t blocks_across;
};

template <bool kRagged, class Code, class Alpha>
HWY_INLINE void draw_one(const SmallSetups& s, std::size_t t, const Code& code_of,
                         const Alpha& alpha, const TilePixels& pixels, FragmentCounts& counts) {
  Ints offset1[kQuadVectors], offset2[kQuadVectors];
  for (std::size_t k = 0; k < kQuadVectors; ++k) {
    const Ints column = quad_columns(k * kLanes), row = quad_rows(k * kLanes);
    offset1[k] = column * s.right1[t] + row * s.down1[t];
    offset2[k] = column * s.right2[t] + row * s.down2[t];
  }
  const Ints area = s.area[t];
  const Ints above0 = s.above0[t], above1 = s.above1[t], above2 = s.above2[t];
  const Floats inverse_area = s.inverse_area[t];
  const Floats depth0 = s.depth0[t], depth1 = s.depth1[t], depth2 = s.depth2[t];
  const Ints seen = s.reference[t];

  const PixelRect& window = pixels.tile.window();
  const auto x0 = std::size_t(s.x0[t]), x1 = std::size_t(s.x1[t]), y1 = std::size_t(s.y1[t]);
  std::int32_t row1 = s.e1[t], row2 = s.e2[t];
  for (auto qy = std::size_t(s.y0[t]); qy < y1; ++qy) {
    std::int32_t first1 = row1, first2 = row2;
    for (std::size_t qx = x0; qx < x1; ++qx) {
      const std::size_t block = (qy / 2) * pixels.blocks_across + qx / 2;
      const std::size_t quad = block * kBlockPixels + ((qy % 2) * 2 + qx % 2) * kQuadPixels;
      for (std::size_t k = 0; k < kQuadVectors; ++k) {
        const Ints e1 = first1 + offset1[k];
        const Ints e2 = first2 + offset2[k];
        const Ints e0 = area - e1 - e2;
        IntMask covered = e1 > above1 && e2 > above2 && e0 > above0;
        if (kRagged) {
          covered = covered && on_screen(window, window.x0 + int(qx) * kQuadSide,
                                         window.y0 + int(qy) * kQuadSide, k * kLanes);
        }
        if (none(covered)) continue;
        if (HWY_UNLIKELY(pixels.blocks[block].plain)) fill_block(pixels.tile, block);
        pixels.blocks[block].nearest = kNearestTileDepth;
        const Ints code =
            code_of(interpolate(depth0, depth1, depth2, screen_weight(to_float(e1), inverse_area),
                                screen_weight(to_float(e2), inverse_area)));
        TileDepth* depth_at_quad = pixels.depth + quad + k * kLanes;
        std::int32_t* seen_at_quad = pixels.seen + quad + k * kLanes;
        const Ints stored = load(depth_at_quad);
        IntMask passes = covered && code < stored;
        counts.covered += count_of(covered);
        if constexpr (!Alpha::kKeepsAll) {
          if (none(passes)) continue;
          const IntMask kept =
              alpha.kept(passes, Reference(s.reference[t]), window.x0 + int(qx) * kQuadSide,
                         window.y0 + int(qy) * kQuadSide, k * kLanes);
          counts.*Alpha::kOthers += count_of(passes) - count_of(kept);
          passes = kept;
        }
        store(select(passes, code, stored), depth_at_quad);
        store(select(passes, seen, load(seen_at_quad)), seen_at_quad);
        counts.written += count_of(passes);
      }
      first1 += s.right1[t] * kQuadSide;
      first2 += s.right2[t] * kQuadSide;
    }
    row1 += s.down1[t] * kQuadSide;
    row2 += s.down2[t] * kQuadSide;
  }
}

template <bool kRagged, class Code, class Alpha>
HWY_INLINE void draw_all(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                         const Code& code_of, const Alpha& alpha, std::span<TileBuffer> tiles,
                         FragmentCounts& counts) {
  FragmentCounts own;
  SmallSetups setups;
  for (std::size_t i = 0; i < count; i += kSmallBatch) {
    const std::size_t live = HWY_MIN(kSmallBatch, count - i);
    for (std::size_t k = 0; k < live; k += kLanes) {
      HWY_ALIGN std::int32_t lanes[kLanes];
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        lanes[lane] = std::int32_t(triangles[i + HWY_MIN(k + lane, live - 1)]);
      }
      set_up(job, load(lanes), tiles.front().window(), setups, k);
    }
    for (TileBuffer& tile : tiles) {
      for (std::size_t k = 0; k < live; k += kLanes) place(tile, setups, k);
      const TilePixels pixels(tile);
      for (std::size_t k = 0; k < live; ++k) {
        draw_one<kRagged>(setups, k, code_of, alpha, pixels, own);
      }
    }
  }
  counts.covered += own.covered;
  counts.written += own.written;
  counts.discarded += own.discarded;
  counts.blended += own.blended;
}

template <class Alpha>
HWY_INLINE void draw_small(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                           const Alpha& alpha, std::span<TileBuffer> tiles,
                           FragmentCounts& counts) {
  with_code(tiles.front().format(), [&](const auto& code_of) HWY_ATTR {
    // Alpha costs more than a look at the screen's edge: one loop serves it.
    if constexpr (Alpha::kKeepsAll) {
      if (!tiles.front().is_ragged()) {
        return draw_all<false>(job, triangles, count, code_of, alpha, tiles, counts);
      }
    }
    draw_all<true>(job, triangles, count, code_of, alpha, tiles, counts);
  });
}

inline void draw_small(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                       std::span<TileBuffer> tiles, FragmentCounts& counts) {
  draw_small(job, triangles, count, Opaque(), tiles, counts);
}
inline void draw_small_masked(const SmallJob& job, const AlphaTest& test,
                              const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                              FragmentCounts& counts) {
  draw_small(job, triangles, count, Masked(test), {&tile, 1}, counts);
}
inline void draw_small_blended(const SmallJob& job, const BlendJob& blend,
                               const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                               FragmentCounts& counts) {
  draw_small(job, triangles, count, Blended(blend), {&tile, 1}, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
