// Selects the triangles that may cover a pixel, and finds their tiles: many at once, before any of
// them is set up.

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "select_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/kernel_functions-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Loads the indices of kLanes triangles, beginning with triangle `first`.
HWY_INLINE PerVertex<Ints> load_indices(IndexTriples triples, std::uint32_t first) {
  PerVertex<Ints> indices;
  hn::LoadInterleaved3(kI, reinterpret_cast<const std::int32_t*>(triples) + std::size_t(first) * 3,
                       indices[0].v, indices[1].v, indices[2].v);
  return indices;
}

// Stores the words of the kept lanes one after the other; the words after them are unspecified.
HWY_INLINE void store_kept(Ints words, IntMask keep, std::uint32_t* to) {
  hn::StoreU(first_kept(words, keep).v, kI, reinterpret_cast<std::int32_t*>(to));
}

std::size_t select_triangles(const SelectJob& job, const BinColumns& selected,
                             SelectCounts& counts) {
  std::size_t kept = 0;
  const Ints small = kSmallSide * kSubpixels;
  const IntMask nowhere = small < small;
  for (std::uint32_t i = 0; i < job.count; i += std::uint32_t(kLanes)) {
    IntMask live = first_lanes(job.count - i);
    if (job.keep != nullptr) live = live && Ints(hn::LoadU(kI, job.keep + i)) > 0;
    const Ints triangle = least(hn::Iota(kI, std::int32_t(job.first + i)),
                                Ints(std::int32_t(job.first + job.count - 1)));
    const PerVertex<Ints> vertices = job.count - i >= kLanes
                                         ? load_indices(job.positions, job.first + i)
                                         : gather_indices(job.positions, triangle);
    const ScreenColumns columns(job.screen, vertices);
    const PerVertex<Ints>&x = columns.x, &y = columns.y;
    const Ints left = smallest(x), right = largest(x), top = smallest(y), bottom = largest(y);

    // A difference that wraps around is negative: the triangle is not small.
    const Ints wide = right - left, high = bottom - top;
    IntMask is_small = small >= wide && small >= high && wide >= 0 && left > kNeedsClipping;
    if (job.all_large) is_small = nowhere;
    const IntMask is_large = live && !is_small;
    is_small = is_small && live;

    const Ints area = double_area(x, y);
    const IntMask flat = is_small && area == 0;
    const IntMask clockwise = area > 0, counter = area < 0;
    const IntMask front = job.mirrored ? clockwise : counter;
    const IntMask back = job.mirrored ? counter : clockwise;
    const IntMask facing =
        is_small && ((job.keep_front ? front : nowhere) || (job.keep_back ? back : nowhere));
    counts.small += count_of(is_small);
    counts.zero_area += count_of(flat);
    counts.culled += count_of(is_small) - count_of(flat) - count_of(facing);

    const Ints x0 = greatest(first_pixel(left) - job.margin, Ints(job.window.x0));
    const Ints y0 = greatest(first_pixel(top) - job.margin, Ints(job.window.y0));
    const Ints x1 = least(end_pixel(right) + job.margin, Ints(job.window.x1));
    const Ints y1 = least(end_pixel(bottom) + job.margin, Ints(job.window.y1));
    const IntMask meets_pixels = x0 < x1 && y0 < y1;
    const IntMask keep = (facing && meets_pixels) || is_large;
    if (none(keep)) continue;

    const auto to_tile = [&](Ints pixel)
                             HWY_ATTR { return Ints(hn::ShiftRightSame(pixel.v, job.tile_shift)); };
    const auto in_one_word = [&](Ints tile_x, Ints tile_y)
                                 HWY_ATTR { return tile_x | shifted_left<16>(tile_y); };
    const BinColumns to = selected.starting_at(kept);
    store_kept(triangle | select(is_large, std::int32_t(kLarge), 0), keep, to.entries);
    store_kept(in_one_word(to_tile(x0), to_tile(y0)), keep, to.first);
    store_kept(in_one_word(to_tile(x1 - 1), to_tile(y1 - 1)), keep, to.last);
    kept += count_of(keep);
  }
  return kept;
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
