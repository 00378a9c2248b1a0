// Sets up small triangles, as many at once as there are lanes: their edges, their depths, and which
// quads of a tile they may cover.

#if defined(GLASSBOX_SMALL_SETUPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SMALL_SETUPS_INL_H_
#undef GLASSBOX_SMALL_SETUPS_INL_H_
#else
#define GLASSBOX_SMALL_SETUPS_INL_H_
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/raster/lanes/quads-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Triangles are set up in batches of this size. So the table entries of all triangles of a batch
// are being fetched from memory at the same time, before the first triangle is drawn.
inline constexpr std::size_t kSmallBatch = 64;

// A batch of small triangles, set up: one column for each triangle. Edge functions 1 and 2 are
// stored; edge function 0 is the area minus these two.
struct SmallSetups {
  template <class T>
  using Row = T[kSmallBatch];

  HWY_ALIGN Row<std::int32_t> reference;
  // The change of an edge function per 1/256 pixel to the right and downwards, as 16-bit integers.
  // (Sides of at most 64 pixels are 2^14 such units long.)
  HWY_ALIGN Row<std::int32_t> slopes1, slopes2;
  HWY_ALIGN Row<std::int32_t> above0, above1, above2;
  HWY_ALIGN Row<std::int32_t> area;
  HWY_ALIGN Row<float> inverse_area;
  HWY_ALIGN Row<float> depth0, depth1, depth2;           // depth1 and depth2 minus depth0
  HWY_ALIGN Row<std::int32_t> left, top, right, bottom;  // of the bounding box
  // Edge functions at the centre of the tile's first pixel.
  HWY_ALIGN Row<std::int32_t> origin1, origin2;

  // The triangle's part of the tile, for the point of each pixel that the tile stores.
  HWY_ALIGN Row<std::int32_t> x0, y0, x1, y1;  // in quads of the tile; x1, y1 are excluded
  HWY_ALIGN Row<std::int32_t> e1, e2;   // edge functions at the first pixel of the first quad
  HWY_ALIGN Row<std::int32_t> is_tiny;  // its box has at most 4 x 4 pixels

  // A mask of the quads that the triangle may cover, for boxes that touch at most 4 x 4 quads: bit
  // 4 y + x. `wide` marks the triangles with larger boxes: bit t for triangle t.
  HWY_ALIGN Row<std::uint16_t> quads;
  std::uint64_t wide;
};
static_assert(kSmallBatch <= 64);
inline constexpr std::int32_t kMaskSide = 4;  // of SmallSetups::quads, in quads

HWY_INLINE void set_up(const SmallJob& job, Ints triangle, const PixelRect& window, SmallSetups& to,
                       std::size_t at) {
  const ScreenColumns columns(job.screen, gather_indices(job.positions, triangle));
  PerVertex<Ints> x = columns.x, y = columns.y;
  PerVertex<Floats> z = columns.z;
  const Ints signed_area = double_area(x, y);
  const VertexOrder order = vertex_order(signed_area, z);
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
  store(pair_of(edge1.a, edge1.b), to.slopes1 + at);
  store(pair_of(edge2.a, edge2.b), to.slopes2 + at);
  store(outside_up_to(edge0), to.above0 + at);
  store(outside_up_to(edge1), to.above1 + at);
  store(outside_up_to(edge2), to.above2 + at);
  store(area, to.area + at);
  store(1.0f / to_float(area), to.inverse_area + at);
  store(z[0], to.depth0 + at);
  store(z[1] - z[0], to.depth1 + at);
  store(z[2] - z[0], to.depth2 + at);
}

// For triangles that are tested at one point of each pixel. The edge functions are stored for this
// point.
struct AtOnePoint {
  SampleOffset point;

  std::int32_t left() const { return point.x; }
  std::int32_t right() const { return point.x; }
  std::int32_t top() const { return point.y; }
  std::int32_t bottom() const { return point.y; }
  SampleOffset edges_at() const { return point; }
  // By how much an edge function can be larger at another tested point: there is no other one.
  template <class I>
  HWY_INLINE I rise(I, I) const {
    return 0;
  }
};
// For triangles that are tested at several points of each pixel, whose extremes are stored here.
// The edge functions are stored for the pixel's centre.
struct AtSomePoints {
  explicit AtSomePoints(std::span<const TileBuffer> tiles) {
    for (const TileBuffer& tile : tiles) {
      least.x = std::min(least.x, tile.point().x);
      least.y = std::min(least.y, tile.point().y);
      most.x = std::max(most.x, tile.point().x);
      most.y = std::max(most.y, tile.point().y);
    }
  }

  std::int32_t left() const { return least.x; }
  std::int32_t right() const { return most.x; }
  std::int32_t top() const { return least.y; }
  std::int32_t bottom() const { return most.y; }
  SampleOffset edges_at() const { return {}; }
  HWY_INLINE Ints rise(Ints right_slope, Ints down_slope) const {
    return greatest(right_slope * least.x, right_slope * most.x) +
           greatest(down_slope * least.y, down_slope * most.y);
  }
  HWY_INLINE std::int32_t rise(std::int32_t right_slope, std::int32_t down_slope) const {
    return std::max(right_slope * least.x, right_slope * most.x) +
           std::max(down_slope * least.y, down_slope * most.y);
  }

  SampleOffset least, most;
};

// For kLanes triangles: an edge function at the pixel of a quad where it is largest, minus the
// largest value outside the triangle. If it is positive, the quad may have a pixel inside this
// edge.
struct GreatestInQuad {
  template <class Points>
  HWY_INLINE GreatestInQuad(const Points& points, Ints at_first_pixel, Ints right_slope,
                            Ints down_slope, Ints outside)
      : right(shifted_left<kSubpixelBits>(right_slope)),
        down(shifted_left<kSubpixelBits>(down_slope)) {
    const Ints rise = greatest(right, 0) + greatest(down, 0);
    here = at_first_pixel + (rise + rise + rise) + points.rise(right_slope, down_slope) - outside;
  }
  HWY_INLINE void next_column() { here = here + shifted_left<2>(right); }
  HWY_INLINE void next_row() { here = here + shifted_left<2>(down); }

  Ints right, down, here;
};

// Finds the quads that kLanes triangles may cover: quads that have, for each edge, a pixel on its
// inner side. Only triangles in `live` lanes are examined.
template <class Points>
HWY_INLINE void find_quads(const Points& points, SmallSetups& s, std::size_t at, IntMask live) {
  const Ints across = load(s.x1 + at) - load(s.x0 + at), high = load(s.y1 + at) - load(s.y0 + at);
  const IntMask wide = live && (across > kMaskSide || high > kMaskSide);
  s.wide = (at == 0 ? 0 : s.wide) | bits_of(wide) << at;
  live = live && !wide;

  const Ints slopes1 = load(s.slopes1 + at), slopes2 = load(s.slopes2 + at);
  const Ints a1 = first_int16(slopes1), a2 = first_int16(slopes2);
  const Ints b1 = second_int16(slopes1), b2 = second_int16(slopes2);
  const Ints e1 = load(s.e1 + at), e2 = load(s.e2 + at);
  GreatestInQuad row0(points, load(s.area + at) - e1 - e2, 0 - a1 - a2, 0 - b1 - b2,
                      load(s.above0 + at));
  GreatestInQuad row1(points, e1, a1, b1, load(s.above1 + at));
  GreatestInQuad row2(points, e2, a2, b2, load(s.above2 + at));
  Ints quads = 0;
  for (std::int32_t y = 0; y < kMaskSide; ++y) {
    const IntMask in_row = live && high > y;
    if (none(in_row)) break;
    GreatestInQuad quad0 = row0, quad1 = row1, quad2 = row2;
    for (std::int32_t x = 0; x < kMaskSide; ++x) {
      const IntMask in_box = in_row && across > x;
      if (none(in_box)) break;
      const IntMask met = in_box && quad0.here > 0 && quad1.here > 0 && quad2.here > 0;
      quads = select(met, quads | (1 << (y * kMaskSide + x)), quads);
      quad0.next_column();
      quad1.next_column();
      quad2.next_column();
    }
    row0.next_row();
    row1.next_row();
    row2.next_row();
  }
  store_int16(quads, s.quads + at);
}

// Finds which quads one triangle may cover among the 4 x 4 quads of its box that begin at column x,
// row y: one quad in each lane. The box may have more columns and rows of quads.
template <class Points>
HWY_INLINE std::uint32_t find_quads_from(const Points& points, const SmallSetups& s, std::size_t t,
                                         std::int32_t x, std::int32_t y) {
  const auto slopes1 = std::uint32_t(s.slopes1[t]), slopes2 = std::uint32_t(s.slopes2[t]);
  const std::int32_t a1 = std::int16_t(slopes1), b1 = std::int16_t(slopes1 >> 16);
  const std::int32_t a2 = std::int16_t(slopes2), b2 = std::int16_t(slopes2 >> 16);
  const auto rise = [&](std::int32_t a, std::int32_t b) {
    return 3 * kSubpixels * (HWY_MAX(a, 0) + HWY_MAX(b, 0)) + points.rise(a, b);
  };
  const Ints rise0 = rise(-a1 - a2, -b1 - b2), rise1 = rise(a1, b1), rise2 = rise(a2, b2);
  std::uint32_t quads = 0;
  for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
    const Ints column = quad_columns(k) + x, row = quad_rows(k) + y;
    const Ints pixel = shifted_left<2>(pair_of(column, row));
    const Ints e1 = s.e1[t] + shifted_left<kSubpixelBits>(sum_of_products(s.slopes1[t], pixel));
    const Ints e2 = s.e2[t] + shifted_left<kSubpixelBits>(sum_of_products(s.slopes2[t], pixel));
    const Ints e0 = s.area[t] - e1 - e2;
    const IntMask in_box = s.x1[t] - s.x0[t] > column && s.y1[t] - s.y0[t] > row;
    const IntMask met =
        in_box && e0 + rise0 > s.above0[t] && e1 + rise1 > s.above1[t] && e2 + rise2 > s.above2[t];
    quads |= std::uint32_t(bits_of(met)) << k;
  }
  return quads;
}

// Computes which part of the tile, whose pixels on the screen are `window`, kLanes triangles may
// cover, and their edge functions there. Only lanes in `live` hold a triangle. (An edge function at
// the tile's first pixel may not fit in 32 bits. At the triangle's own pixels it fits, and sums
// that wrap around still give the right value there.)
template <class Points>
HWY_INLINE void place_in_tile(const PixelRect& window, const Points& points, SmallSetups& s,
                              std::size_t at, IntMask live) {
  const Ints px0 =
      greatest(first_pixel(load(s.left + at) - points.right()), Ints(window.x0)) - window.x0;
  const Ints py0 =
      greatest(first_pixel(load(s.top + at) - points.bottom()), Ints(window.y0)) - window.y0;
  const Ints px1 =
      least(end_pixel(load(s.right + at) - points.left()), Ints(window.x1)) - window.x0;
  const Ints py1 =
      least(end_pixel(load(s.bottom + at) - points.top()), Ints(window.y1)) - window.y0;
  const Ints qx0 = shifted_right<2>(px0), qy0 = shifted_right<2>(py0);
  store(qx0, s.x0 + at);
  store(qy0, s.y0 + at);
  store(one_where(px1 - px0 < 5 && py1 - py0 < 5), s.is_tiny + at);
  store(shifted_right<2>(px1 + 3), s.x1 + at);
  store(shifted_right<2>(py1 + 3), s.y1 + at);

  const SampleOffset edges_at = points.edges_at();
  const Ints dx = shifted_left<2 + kSubpixelBits>(qx0) + edges_at.x;
  const Ints dy = shifted_left<2 + kSubpixelBits>(qy0) + edges_at.y;
  const auto edge_at = [&](const std::int32_t* origin, Ints slopes) HWY_ATTR {
    return load(origin + at) + first_int16(slopes) * dx + second_int16(slopes) * dy;
  };
  store(edge_at(s.origin1, load(s.slopes1 + at)), s.e1 + at);
  store(edge_at(s.origin2, load(s.slopes2 + at)), s.e2 + at);
  find_quads(points, s, at, live);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
