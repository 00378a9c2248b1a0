// Small triangles into a tile: as many as there are lanes are set up at once; then each is tested against the quads of pixels
// that its box meets, a quad at a time.

#if defined(GLASSBOX_SMALL_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SMALL_TRIANGLES_INL_H_
#undef GLASSBOX_SMALL_TRIANGLES_INL_H_
#else
#define GLASSBOX_SMALL_TRIANGLES_INL_H_
#endif

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
  HWY_ALIGN Row<std::int32_t> e1, e2;          // at the first pixel of the first quad
  HWY_ALIGN Row<std::int32_t> right1, right2;  // what a step of one pixel adds
  HWY_ALIGN Row<std::int32_t> down1, down2;
  HWY_ALIGN Row<std::int32_t> above0, above1, above2;
  HWY_ALIGN Row<std::int32_t> area;
  HWY_ALIGN Row<float> inverse_area;
  HWY_ALIGN Row<float> depth0, depth1, depth2;  // 1 and 2 less 0
  HWY_ALIGN Row<std::int32_t> x0, y0, x1, y1;   // quads of the tile, x1 and y1 excluded
};

HWY_INLINE void set_up(const SmallJob& job, VI triangle, const PixelRect& window, SmallSetups& to,
                       std::size_t at) {
  const Triple<VI> vertices = gather_indices(job.positions, triangle);
  const Triple<VI> entries = entries_of(vertices);
  Triple<VI> x, y;
  gather_position(job.screen, entries, x, y);
  Triple<VF> z = gather_z(job.screen, entries);
  const VI signed_area = double_area(x, y);
  const Order order = order_of(signed_area, z);
  x = put_in_order(order, x);
  y = put_in_order(order, y);
  z = put_in_order(order, z);
  const VI area = hn::Abs(signed_area);
  const VI step = set(std::int32_t(kReferenceStep));
  hn::Store(hn::Add(set(std::int32_t(job.first_reference)),
                    hn::Or(hn::Mul(triangle, step), code_of(order))),
            kI, to.reference + at);

  // Pixels of the box, in the tile.
  const VI px0 = hn::Sub(hn::Max(first_pixel(smallest(x)), set(window.x0)), set(window.x0));
  const VI py0 = hn::Sub(hn::Max(first_pixel(smallest(y)), set(window.y0)), set(window.y0));
  const VI px1 = hn::Sub(hn::Min(end_pixel(largest(x)), set(window.x1)), set(window.x0));
  const VI py1 = hn::Sub(hn::Min(end_pixel(largest(y)), set(window.y1)), set(window.y0));
  const VI qx0 = hn::ShiftRight<2>(px0), qy0 = hn::ShiftRight<2>(py0);
  hn::Store(qx0, kI, to.x0 + at);
  hn::Store(qy0, kI, to.y0 + at);
  hn::Store(hn::ShiftRight<2>(hn::Add(px1, set(3))), kI, to.x1 + at);
  hn::Store(hn::ShiftRight<2>(hn::Add(py1, set(3))), kI, to.y1 + at);

  const VI at_x =
      hn::Add(hn::ShiftLeft<2 + kSubpixelBits>(qx0), set(window.x0 * kSubpixels + kPixelCentre));
  const VI at_y =
      hn::Add(hn::ShiftLeft<2 + kSubpixelBits>(qy0), set(window.y0 * kSubpixels + kPixelCentre));
  const EdgeLanes edge0 = edge_at(x.v1, y.v1, x.v2, y.v2, at_x, at_y);
  const EdgeLanes edge1 = edge_at(x.v2, y.v2, x.v0, y.v0, at_x, at_y);
  const EdgeLanes edge2 = edge_at(x.v0, y.v0, x.v1, y.v1, at_x, at_y);
  hn::Store(edge1.value, kI, to.e1 + at);
  hn::Store(edge2.value, kI, to.e2 + at);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge1.a), kI, to.right1 + at);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge2.a), kI, to.right2 + at);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge1.b), kI, to.down1 + at);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge2.b), kI, to.down2 + at);
  hn::Store(outside_up_to(edge0), kI, to.above0 + at);
  hn::Store(outside_up_to(edge1), kI, to.above1 + at);
  hn::Store(outside_up_to(edge2), kI, to.above2 + at);
  hn::Store(area, kI, to.area + at);
  hn::Store(hn::Div(set(1.0f), to_float(area)), kF, to.inverse_area + at);
  hn::Store(z.v0, kF, to.depth0 + at);
  hn::Store(hn::Sub(z.v1, z.v0), kF, to.depth1 + at);
  hn::Store(hn::Sub(z.v2, z.v0), kF, to.depth2 + at);
}

// Lanes that are pixels of the screen, where the tile reaches beyond it.
HWY_INLINE MI on_screen(const PixelRect& window, int x, int y, std::size_t i) {
  return hn::And(hn::Lt(hn::Add(quad_columns(i), set(x)), set(window.x1)),
                 hn::Lt(hn::Add(quad_rows(i), set(y)), set(window.y1)));
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

template <bool kRagged, class Code>
HWY_INLINE void draw_one(const SmallSetups& s, std::size_t t, const Code& code_of,
                         const TilePixels& pixels, FragmentCounts& counts) {
  VI offset1[kQuadVectors], offset2[kQuadVectors];
  for (std::size_t k = 0; k < kQuadVectors; ++k) {
    const VI column = quad_columns(k * kLanes), row = quad_rows(k * kLanes);
    offset1[k] = hn::Add(hn::Mul(set(s.right1[t]), column), hn::Mul(set(s.down1[t]), row));
    offset2[k] = hn::Add(hn::Mul(set(s.right2[t]), column), hn::Mul(set(s.down2[t]), row));
  }
  const VI area = set(s.area[t]);
  const VI above0 = set(s.above0[t]), above1 = set(s.above1[t]), above2 = set(s.above2[t]);
  const VF inverse_area = set(s.inverse_area[t]);
  const VF depth0 = set(s.depth0[t]), depth1 = set(s.depth1[t]), depth2 = set(s.depth2[t]);
  const VI seen = set(s.reference[t]);

  const auto x0 = std::size_t(s.x0[t]), x1 = std::size_t(s.x1[t]), y1 = std::size_t(s.y1[t]);
  std::int32_t row1 = s.e1[t], row2 = s.e2[t];
  for (auto qy = std::size_t(s.y0[t]); qy < y1; ++qy) {
    std::int32_t first1 = row1, first2 = row2;
    for (std::size_t qx = x0; qx < x1; ++qx) {
      const std::size_t block = (qy / 2) * pixels.blocks_across + qx / 2;
      const std::size_t quad = block * kBlockPixels + ((qy % 2) * 2 + qx % 2) * kQuadPixels;
      for (std::size_t k = 0; k < kQuadVectors; ++k) {
        const VI e1 = hn::Add(set(first1), offset1[k]);
        const VI e2 = hn::Add(set(first2), offset2[k]);
        const VI e0 = hn::Sub(hn::Sub(area, e1), e2);
        MI covered = hn::And(hn::And(hn::Gt(e1, above1), hn::Gt(e2, above2)), hn::Gt(e0, above0));
        if (kRagged) {
          const PixelRect& window = pixels.tile.window();
          covered = hn::And(covered, on_screen(window, window.x0 + int(qx) * kQuadSide,
                                               window.y0 + int(qy) * kQuadSide, k * kLanes));
        }
        if (hn::AllFalse(kI, covered)) continue;
        if (HWY_UNLIKELY(pixels.blocks[block].plain)) fill_block(pixels.tile, block);
        pixels.blocks[block].nearest = kNearestTileDepth;
        const VI code =
            code_of(depth_at(depth0, depth1, depth2, hn::Mul(to_float(e1), inverse_area),
                             hn::Mul(to_float(e2), inverse_area)));
        TileDepth* depth_at_quad = pixels.depth + quad + k * kLanes;
        std::int32_t* seen_at_quad = pixels.seen + quad + k * kLanes;
        const VI stored = hn::Load(kI, depth_at_quad);
        const MI passes = hn::And(covered, hn::Lt(code, stored));
        hn::Store(hn::IfThenElse(passes, code, stored), kI, depth_at_quad);
        hn::Store(hn::IfThenElse(passes, seen, hn::Load(kI, seen_at_quad)), kI, seen_at_quad);
        counts.covered += hn::CountTrue(kI, covered);
        counts.written += hn::CountTrue(kI, passes);
      }
      first1 += s.right1[t] * kQuadSide;
      first2 += s.right2[t] * kQuadSide;
    }
    row1 += s.down1[t] * kQuadSide;
    row2 += s.down2[t] * kQuadSide;
  }
}

template <bool kRagged, class Code>
HWY_INLINE void draw_all(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                         const Code& code_of, TileBuffer& tile, FragmentCounts& counts) {
  const TilePixels pixels(tile);
  FragmentCounts own;
  SmallSetups setups;
  for (std::size_t i = 0; i < count; i += kSmallBatch) {
    const std::size_t live = HWY_MIN(kSmallBatch, count - i);
    for (std::size_t k = 0; k < live; k += kLanes) {
      HWY_ALIGN std::int32_t lanes[kLanes];
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        lanes[lane] = std::int32_t(triangles[i + HWY_MIN(k + lane, live - 1)]);
      }
      set_up(job, hn::Load(kI, lanes), tile.window(), setups, k);
    }
    for (std::size_t k = 0; k < live; ++k) draw_one<kRagged>(setups, k, code_of, pixels, own);
  }
  counts.covered += own.covered;
  counts.written += own.written;
}

inline void draw_small(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                       TileBuffer& tile, FragmentCounts& counts) {
  with_code(tile.format(), [&](const auto& code_of) HWY_ATTR {
    if (tile.is_ragged()) {
      draw_all<true>(job, triangles, count, code_of, tile, counts);
    } else {
      draw_all<false>(job, triangles, count, code_of, tile, counts);
    }
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
