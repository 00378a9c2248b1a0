// Which triangles may cover a pixel, and in which tiles: many at a time, before any of them is set up.

#if defined(GLASSBOX_SELECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SELECT_INL_H_
#undef GLASSBOX_SELECT_INL_H_
#else
#define GLASSBOX_SELECT_INL_H_
#endif

#include <glassbox/raster/lanes/setup-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

HWY_INLINE VI smallest(const Triple<VI>& v) {
  return hn::Min(v.v0, hn::Min(v.v1, v.v2));
}
HWY_INLINE VI largest(const Triple<VI>& v) {
  return hn::Max(v.v0, hn::Max(v.v1, v.v2));
}

// As pixels_in_box() of triangle_setup.h.
HWY_INLINE VI first_pixel(VI low) {
  return hn::ShiftRight<kSubpixelBits>(hn::Add(low, set(kPixelCentre - 1)));
}
HWY_INLINE VI end_pixel(VI high) {
  return hn::Add(hn::ShiftRight<kSubpixelBits>(hn::Sub(high, set(kPixelCentre))), set(1));
}

// The indices of kLanes triangles from `first` on.
HWY_INLINE Triple<VI> load_indices(IndexTriples triples, std::uint32_t first) {
  Triple<VI> indices;
  hn::LoadInterleaved3(kI, reinterpret_cast<const std::int32_t*>(triples) + std::size_t(first) * 3,
                       indices.v0, indices.v1, indices.v2);
  return indices;
}

// Writes those that are left to `selected`, which has room for job.count, and returns how many there are.
inline std::size_t select_triangles(const SelectJob& job, Selected* selected,
                                    SelectCounts& counts) {
  std::size_t kept = 0;
  const VI small = set(kSmallSide * kSubpixels);
  for (std::uint32_t i = 0; i < job.count; i += std::uint32_t(kLanes)) {
    MI live = first_lanes(job.count - i);
    if (job.keep != nullptr) {
      live = hn::And(live, hn::Gt(hn::LoadU(kI, job.keep + i), hn::Zero(kI)));
    }
    const VI triangle = hn::Min(hn::Iota(kI, std::int32_t(job.first + i)),
                                set(std::int32_t(job.first + job.count - 1)));
    const Triple<VI> vertices = job.count - i >= kLanes ? load_indices(job.positions, job.first + i)
                                                        : gather_indices(job.positions, triangle);
    const Triple<VI> entries = entries_of(vertices);
    Triple<VI> x, y;
    gather_position(job.screen, entries, x, y);
    const VI left = smallest(x), right = largest(x), top = smallest(y), bottom = largest(y);

    // A difference that wraps around is negative: the triangle is not small.
    const VI wide = hn::Sub(right, left), high = hn::Sub(bottom, top);
    MI is_small = hn::And(hn::And(at_least(small, wide), at_least(small, high)),
                          hn::And(at_least(wide, hn::Zero(kI)), hn::Gt(left, set(kNeedsClipping))));
    if (job.all_large) is_small = hn::Lt(wide, wide);
    const MI is_large = hn::AndNot(is_small, live);
    is_small = hn::And(is_small, live);

    const VI area = double_area(x, y);
    const MI flat = hn::And(is_small, hn::Eq(area, hn::Zero(kI)));
    const MI clockwise = hn::Gt(area, hn::Zero(kI));
    const MI counter = hn::Lt(area, hn::Zero(kI));
    const MI front = job.mirrored ? clockwise : counter;
    const MI back = job.mirrored ? counter : clockwise;
    const MI none = hn::Lt(area, area);
    const MI facing =
        hn::And(is_small, hn::Or(job.keep_front ? front : none, job.keep_back ? back : none));
    counts.small += hn::CountTrue(kI, is_small);
    counts.zero_area += hn::CountTrue(kI, flat);
    counts.culled +=
        hn::CountTrue(kI, is_small) - hn::CountTrue(kI, flat) - hn::CountTrue(kI, facing);

    const VI x0 = hn::Max(first_pixel(left), set(job.window.x0));
    const VI y0 = hn::Max(first_pixel(top), set(job.window.y0));
    const VI x1 = hn::Min(end_pixel(right), set(job.window.x1));
    const VI y1 = hn::Min(end_pixel(bottom), set(job.window.y1));
    const MI meets_pixels = hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1));
    const MI keep = hn::Or(hn::And(facing, meets_pixels), is_large);
    if (hn::AllFalse(kI, keep)) continue;

    HWY_ALIGN std::int32_t triangles[kLanes], low_x[kLanes], low_y[kLanes], high_x[kLanes],
        high_y[kLanes];
    const auto to_tile = [&](VI pixel)
                             HWY_ATTR { return hn::ShiftRightSame(pixel, job.tile_shift); };
    const VI marked = hn::Or(triangle, hn::IfThenElseZero(is_large, set(std::int32_t(kLarge))));
    hn::CompressStore(marked, keep, kI, triangles);
    hn::CompressStore(to_tile(x0), keep, kI, low_x);
    hn::CompressStore(to_tile(y0), keep, kI, low_y);
    hn::CompressStore(to_tile(hn::Sub(x1, set(1))), keep, kI, high_x);
    hn::CompressStore(to_tile(hn::Sub(y1, set(1))), keep, kI, high_y);
    const std::size_t found = hn::CountTrue(kI, keep);
    for (std::size_t k = 0; k < found; ++k) {
      selected[kept++] = {std::uint32_t(triangles[k]), std::uint16_t(low_x[k]),
                          std::uint16_t(low_y[k]), std::uint16_t(high_x[k]),
                          std::uint16_t(high_y[k])};
    }
  }
  return kept;
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
