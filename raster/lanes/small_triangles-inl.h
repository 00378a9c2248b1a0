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

// A batch of small triangles, set up: one column a triangle. Edges 1 and 2 are kept; edge 0 is what they leave of the area.
struct SmallSetups {
  HWY_ALIGN std::int32_t e1[kLanes], e2[kLanes];          // at the first pixel of the first quad
  HWY_ALIGN std::int32_t right1[kLanes], right2[kLanes];  // what a step of one pixel adds
  HWY_ALIGN std::int32_t down1[kLanes], down2[kLanes];
  HWY_ALIGN std::int32_t above0[kLanes], above1[kLanes], above2[kLanes];
  HWY_ALIGN std::int32_t area[kLanes];
  HWY_ALIGN float inverse_area[kLanes];
  HWY_ALIGN float depth0[kLanes], depth1[kLanes], depth2[kLanes];  // 1 and 2 less 0
  HWY_ALIGN std::int32_t x0[kLanes], y0[kLanes], x1[kLanes],
      y1[kLanes];  // quads of the tile, x1 and y1 excluded
};

HWY_INLINE void set_up(const SmallJob& job, VI triangle, const PixelRect& window, SmallSetups& to) {
  const Triple<VI> vertices = gather_indices(job.positions, triangle);
  const Triple<VI> entries = entries_of(vertices);
  Triple<VI> x = gather_x(job.screen, entries);
  Triple<VI> y = gather_y(job.screen, entries);
  Triple<VF> z = gather_z(job.screen, entries);
  const VI signed_area = double_area(x, y);
  const Order order = order_of(signed_area, z);
  x = put_in_order(order, x);
  y = put_in_order(order, y);
  z = put_in_order(order, z);
  const VI area = hn::Abs(signed_area);

  // Pixels of the box, in the tile.
  const VI px0 = hn::Sub(hn::Max(first_pixel(smallest(x)), set(window.x0)), set(window.x0));
  const VI py0 = hn::Sub(hn::Max(first_pixel(smallest(y)), set(window.y0)), set(window.y0));
  const VI px1 = hn::Sub(hn::Min(end_pixel(largest(x)), set(window.x1)), set(window.x0));
  const VI py1 = hn::Sub(hn::Min(end_pixel(largest(y)), set(window.y1)), set(window.y0));
  const VI qx0 = hn::ShiftRight<2>(px0), qy0 = hn::ShiftRight<2>(py0);
  hn::Store(qx0, kI, to.x0);
  hn::Store(qy0, kI, to.y0);
  hn::Store(hn::ShiftRight<2>(hn::Add(px1, set(3))), kI, to.x1);
  hn::Store(hn::ShiftRight<2>(hn::Add(py1, set(3))), kI, to.y1);

  const VI at_x =
      hn::Add(hn::ShiftLeft<2 + kSubpixelBits>(qx0), set(window.x0 * kSubpixels + kPixelCentre));
  const VI at_y =
      hn::Add(hn::ShiftLeft<2 + kSubpixelBits>(qy0), set(window.y0 * kSubpixels + kPixelCentre));
  const EdgeLanes edge0 = edge_at(x.v1, y.v1, x.v2, y.v2, at_x, at_y);
  const EdgeLanes edge1 = edge_at(x.v2, y.v2, x.v0, y.v0, at_x, at_y);
  const EdgeLanes edge2 = edge_at(x.v0, y.v0, x.v1, y.v1, at_x, at_y);
  hn::Store(edge1.value, kI, to.e1);
  hn::Store(edge2.value, kI, to.e2);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge1.a), kI, to.right1);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge2.a), kI, to.right2);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge1.b), kI, to.down1);
  hn::Store(hn::ShiftLeft<kSubpixelBits>(edge2.b), kI, to.down2);
  hn::Store(outside_up_to(edge0), kI, to.above0);
  hn::Store(outside_up_to(edge1), kI, to.above1);
  hn::Store(outside_up_to(edge2), kI, to.above2);
  hn::Store(area, kI, to.area);
  hn::Store(hn::Div(set(1.0f), to_float(area)), kF, to.inverse_area);
  hn::Store(z.v0, kF, to.depth0);
  hn::Store(hn::Sub(z.v1, z.v0), kF, to.depth1);
  hn::Store(hn::Sub(z.v2, z.v0), kF, to.depth2);
}

// Lanes that are pixels of the screen, where the tile reaches beyond it.
HWY_INLINE MI on_screen(const PixelRect& window, int x, int y, std::size_t i) {
  return hn::And(hn::Lt(hn::Add(quad_columns(i), set(x)), set(window.x1)),
                 hn::Lt(hn::Add(quad_rows(i), set(y)), set(window.y1)));
}

template <class Code>
HWY_INLINE void draw_one(const SmallSetups& s, std::size_t t, Reference reference,
                         const Code& code_of, TileBuffer& tile, FragmentCounts& counts) {
  constexpr std::size_t kVectors = kQuadPixels / kLanes;
  VI offset1[kVectors], offset2[kVectors];
  for (std::size_t k = 0; k < kVectors; ++k) {
    const VI column = quad_columns(k * kLanes), row = quad_rows(k * kLanes);
    offset1[k] = hn::Add(hn::Mul(set(s.right1[t]), column), hn::Mul(set(s.down1[t]), row));
    offset2[k] = hn::Add(hn::Mul(set(s.right2[t]), column), hn::Mul(set(s.down2[t]), row));
  }
  const VI area = set(s.area[t]);
  const VI above0 = set(s.above0[t]), above1 = set(s.above1[t]), above2 = set(s.above2[t]);
  const VF inverse_area = set(s.inverse_area[t]);
  const VF depth0 = set(s.depth0[t]), depth1 = set(s.depth1[t]), depth2 = set(s.depth2[t]);
  const VI seen = set(std::int32_t(reference));
  const bool ragged = tile.is_ragged();

  std::int32_t row1 = s.e1[t], row2 = s.e2[t];
  for (int qy = s.y0[t]; qy < s.y1[t]; ++qy) {
    std::int32_t e1_first = row1, e2_first = row2;
    for (int qx = s.x0[t]; qx < s.x1[t]; ++qx) {
      const std::size_t quad = tile.quad_index(qx, qy);
      for (std::size_t k = 0; k < kVectors; ++k) {
        const VI e1 = hn::Add(set(e1_first), offset1[k]);
        const VI e2 = hn::Add(set(e2_first), offset2[k]);
        const VI e0 = hn::Sub(hn::Sub(area, e1), e2);
        MI covered = hn::And(hn::And(hn::Gt(e1, above1), hn::Gt(e2, above2)), hn::Gt(e0, above0));
        if (HWY_UNLIKELY(ragged)) {
          covered = hn::And(covered, on_screen(tile.window(), tile.window().x0 + qx * kQuadSide,
                                               tile.window().y0 + qy * kQuadSide, k * kLanes));
        }
        if (hn::AllFalse(kI, covered)) continue;
        make_plain_block_full(tile, quad / kBlockPixels);
        tile.block(quad / kBlockPixels).nearest = kNearestTileDepth;
        const VF z = depth_at(depth0, depth1, depth2, hn::Mul(to_float(e1), inverse_area),
                              hn::Mul(to_float(e2), inverse_area));
        const VI code = code_of(z);
        TileDepth* depth = tile.depth() + quad + k * kLanes;
        std::int32_t* seen_at =
            reinterpret_cast<std::int32_t*>(tile.reference() + quad) + k * kLanes;
        const VI stored = hn::Load(kI, depth);
        const MI passes = hn::And(covered, hn::Lt(code, stored));
        hn::Store(hn::IfThenElse(passes, code, stored), kI, depth);
        hn::Store(hn::IfThenElse(passes, seen, hn::Load(kI, seen_at)), kI, seen_at);
        counts.covered += hn::CountTrue(kI, covered);
        counts.written += hn::CountTrue(kI, passes);
      }
      e1_first += s.right1[t] * kQuadSide;
      e2_first += s.right2[t] * kQuadSide;
    }
    row1 += s.down1[t] * kQuadSide;
    row2 += s.down2[t] * kQuadSide;
  }
}

inline void draw_small(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                       TileBuffer& tile, FragmentCounts& counts) {
  with_code(tile.format(), [&](const auto& code_of) HWY_ATTR {
    SmallSetups setups;
    HWY_ALIGN std::int32_t batch[kLanes];
    for (std::size_t i = 0; i < count; i += kLanes) {
      const std::size_t live = HWY_MIN(kLanes, count - i);
      for (std::size_t k = 0; k < kLanes; ++k) {
        batch[k] = std::int32_t(triangles[i + HWY_MIN(k, live - 1)]);
      }
      set_up(job, hn::Load(kI, batch), tile.window(), setups);
      for (std::size_t k = 0; k < live; ++k) {
        draw_one(setups, k, job.first_reference + Reference(batch[k]), code_of, tile, counts);
      }
    }
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
