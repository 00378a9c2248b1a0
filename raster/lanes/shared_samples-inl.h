// Finds the small triangles that are seen at the samples of a block. If they are few, the data that
// shading needs of them is gathered once for the block, otherwise for each sample.

#if defined(GLASSBOX_SHARED_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SHARED_SAMPLES_INL_H_
#undef GLASSBOX_SHARED_SAMPLES_INL_H_
#else
#define GLASSBOX_SHARED_SAMPLES_INL_H_
#endif

#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/raster/lanes/samples-inl.h>
#include <glassbox/raster/lanes/shade-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// A list of small triangles that are seen at samples of a block's pixels, each with the index of
// the sample's colour: sample * kBlockPixels + pixel.
struct RemainingSamples {
  // (With room for the lanes that a vector writes beyond the end.)
  static constexpr std::size_t kMost = std::size_t(kMaxSamples) * kBlockPixels + kLanes;
  HWY_INLINE void add(Ints seen, IntMask lanes, std::size_t sample, std::size_t pixel) {
    const Ints index = hn::Iota(kI, std::int32_t(sample * kBlockPixels + pixel));
    hn::StoreU(first_kept(seen, lanes).v, kI, references + count);
    hn::StoreU(first_kept(index, lanes).v, kI, color_indices + count);
    count += count_of(lanes);
  }

  std::size_t count = 0;
  HWY_ALIGN std::int32_t references[kMost];
  HWY_ALIGN std::int32_t color_indices[kMost];
};

// The small triangles that were drawn into a block at any of its samples. The list is empty if
// there are more triangles than lanes.
struct TrianglesAtSamples {
  HWY_INLINE TrianglesAtSamples(std::span<const TileBuffer> tiles, std::size_t block) {
    for (const TileBuffer& tile : tiles) {
      const std::uint32_t listed = tile.block(block).listed;
      bool all = listed <= BlockTriangles::kMost;
      for (std::uint32_t k = 1; all && k <= listed; ++k) {
        all = add(std::int32_t(tile.listed(block).references[k]));
      }
      if (all) continue;
      count = 0;
      return;
    }
  }

  std::int32_t count = 0;
  Ints references = std::int32_t(kNothing);

private:
  // Adds a reference; returns false if there is no room for it.
  HWY_INLINE bool add(std::int32_t reference) {
    if (!none(references == reference)) return true;
    if (count == std::int32_t(kLanes)) return false;
    references = select(Ints(hn::Iota(kI, 0)) == count++, reference, references);
    return true;
  }
};

// For blocks with no small triangles, with too many of them, or with triangles that cannot be
// shared (SharedTriangles::can_share): shade() does nothing, so the data is gathered for each
// sample.
struct NoSharedTriangles {
  HWY_INLINE void shade(const ResolveJob&, Ints, Ints, Ints, IntMask&, Ints&) const {}
};
// For blocks that show few triangles: the data of the triangles of one draw is gathered once for
// the block.
struct SharedTrianglesAtSamples {
  HWY_INLINE SharedTrianglesAtSamples(const ShadeDraw& draw, const TrianglesAtSamples& of_block,
                                      int x, int y)
      : begin(std::int32_t(draw.first_reference)),
        end(std::int32_t(draw.end_reference)),
        listed(of_block),
        triangles(draw, triangles_of(draw, of_block), x, y) {}

  // Computes the colours of the pending lanes that show the draw, and removes these lanes from
  // `pending`.
  HWY_INLINE void shade(const ResolveJob& job, Ints seen, Ints column, Ints row, IntMask& pending,
                        Ints& color) const {
    const IntMask same = pending && seen >= begin && seen < end;
    if (none(same)) return;
    color = select(same, color_of(job, seen, column, row, same), color);
    pending = pending && !same;
  }

private:
  // The triangles' references minus the draw's first reference. Unused lanes get 0, the draw's
  // first triangle.
  HWY_INLINE static Ints triangles_of(const ShadeDraw& draw, const TrianglesAtSamples& listed) {
    const Ints r = listed.references, first = std::int32_t(draw.first_reference);
    return select(r >= first && r < std::int32_t(draw.end_reference), r - first, 0);
  }
  HWY_NOINLINE Ints color_of(const ResolveJob& job, Ints seen, Ints column, Ints row,
                             IntMask lanes) const {
    Ints lane = 0;
    HWY_ALIGN std::int32_t references[kLanes];
    store(listed.references, references);
    for (std::int32_t k = 0; k < listed.count; ++k) {
      lane = select(seen == references[k], k, lane);
    }
    const SharedSource source(triangles, lane, column, row, AtSamples{job.points, lanes});
    const ShadeDraw& draw = *triangles.draw;
    const DrawTextures textures(draw);
    if (textures.color != nullptr || textures.emission != nullptr) {
      return encoded(shaded_color_by_call<AllChannels>(draw, textures, job, source), job);
    }
    return glassbox::HWY_NAMESPACE::shade<AllChannels>(draw, DrawTextures(), job, source);
  }

  Ints begin, end;
  TrianglesAtSamples listed;
  SharedTriangles triangles;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
