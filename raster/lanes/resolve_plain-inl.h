// Resolves plain blocks: blocks that show only the background, or only one large triangle.

#if defined(GLASSBOX_RESOLVE_PLAIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_PLAIN_INL_H_
#undef GLASSBOX_RESOLVE_PLAIN_INL_H_
#else
#define GLASSBOX_RESOLVE_PLAIN_INL_H_
#endif

#include <algorithm>
#include <bit>

#include <glassbox/raster/lanes/tile_rows-inl.h>
#include <glassbox/raster/lanes/visible_shader-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

template <class Channels>
class PlainBlockResolver {
public:
  // `tiles`: as in Kernels::resolve_tile.
  PlainBlockResolver(const ResolveJob& job, std::span<const TileBuffer> tiles, const TileRows& rows,
                     VisibleShader<Channels>& shader)
      : job_(job),
        tiles_(tiles),
        rows_(rows),
        shader_(shader),
        mask_(bytes_of(job.mask)),
        stores_blocks_(job.distance == nullptr && job.id == nullptr && job.samples == nullptr &&
                       (!job.keep_picture || job.points.empty())) {}

  // Whether the block is plain in all tiles, shows the same triangle in each, and may be stored as
  // a whole. (A triangle that covers all samples of a pixel covers its centre too, which is between
  // the samples.)
  HWY_INLINE bool is_plain(std::size_t block) const {
    const TileBlock& first = tiles_.front().block(block);
    return first.plain && stores_blocks_ &&
           std::ranges::all_of(tiles_.subspan(1), [&](const TileBuffer& tile) {
             return tile.block(block).plain && tile.block(block).reference == first.reference;
           });
  }

  // Whether the whole tile has one colour and one depth.
  bool is_constant_tile() const {
    const TileBlock& first = tiles_.front().block(0);
    if (job_.drawn_over || job_.keep_picture || !is_plain(0) || is_shaded(first)) return false;
    if (job_.depth != nullptr && first.triangle != nullptr) return false;
    return std::ranges::all_of(tiles_, [&](const TileBuffer& tile) {
      return std::all_of(&tile.block(0), &tile.block(0) + tile.block_count(),
                         [&](const TileBlock& b) {
                           return b.plain && b.reference == first.reference &&
                                  b.triangle == first.triangle && b.nearest == first.nearest;
                         });
    });
  }

  // Returns the colour of a plain block at (x, y) whose pixels do not differ in colour. One pixel
  // is shaded, and its colour is kept for the following blocks.
  std::uint32_t color_of(const TileBlock& b, int x, int y) {
    if (job_.picture == nullptr) return 0;
    if (!shows_triangle(b)) return std::bit_cast<std::uint32_t>(job_.background);
    if (b.reference != one_color_reference_) {
      one_color_reference_ = b.reference;
      one_color_ = color_at(b.reference, x, y);
    }
    return one_color_;
  }

  // Resolves a plain block that is wholly on the screen.
  HWY_INLINE void resolve(std::size_t block, int x, int y) {
    const TileBlock& b = tiles_.front().block(block);
    if (job_.depth != nullptr) rows_.store_plain_depths(block, x, y);
    if (job_.picture == nullptr) return;
    if (is_shaded(b)) {
      shade(b, x, y);
    } else if (!job_.keep_picture) {
      rows_.fill_colors(color_of(b, x, y), x, y);
    } else if (shows_triangle(b)) {
      Ints colors[kBlockVectors];
      std::fill_n(colors, kBlockVectors, Ints(std::int32_t(color_of(b, x, y))));
      merge_with_picture(colors, x, y);
      rows_.store_colors(colors, x, y);
    }
  }

private:
  static bool shows_triangle(const TileBlock& b) {
    return b.reference != kNothing && b.reference != kInPicture;
  }
  // Whether the pixels of a plain block differ in colour.
  bool is_shaded(const TileBlock& b) const {
    return job_.picture != nullptr && shows_triangle(b) &&
           !job_.large[b.reference & ~kLargeReference]->one_color;
  }

  HWY_NOINLINE std::uint32_t color_at(Reference reference, int x, int y) {
    const LargeShape& shape = shader_.shape_of(reference);
    const LargeSource source(shape, x, y, 0, AtCentre());
    HWY_ALIGN std::int32_t colors[kLanes];
    const Ints shaded = encoded(shaded_color_by_call<Channels>(job_.draws[shape.triangle->draw],
                                                               DrawTextures(), job_, source),
                                job_);
    store(merged_channels(shaded, std::bit_cast<std::int32_t>(job_.background), mask_), colors);
    return std::uint32_t(colors[0]);
  }

  HWY_NOINLINE void shade(const TileBlock& b, int x, int y) {
    const LargeTriangle& triangle = *job_.large[b.reference & ~kLargeReference];
    const ShadeDraw& draw = job_.draws[triangle.draw];
    const DrawTextures textures(draw);
    Ints colors[kBlockVectors];
    const LargeShape& shape = shader_.shape_of(b.reference);
    shade_vectors<Channels, LargeSource>(
        draw, textures, job_, kBlockVectors,
        [&](std::size_t i)
            HWY_ATTR { return VisibleShader<Channels>::large_source(shape, x, y, i); },
        colors);
    if (mask_ != -1) merge_with_picture(colors, x, y);
    rows_.store_colors(colors, x, y);
  }
  HWY_NOINLINE void merge_with_picture(Ints* colors, int x, int y) const {
    Ints before[kBlockVectors];
    rows_.load_colors(before, x, y);
    for (std::size_t i = 0; i < kBlockVectors; ++i)
      colors[i] = merged_channels(colors[i], before[i], mask_);
  }

  const ResolveJob& job_;
  std::span<const TileBuffer> tiles_;
  const TileRows& rows_;
  VisibleShader<Channels>& shader_;
  std::int32_t mask_;
  // Whether plain blocks may be stored without reading what their pixels have in other images: not
  // if distances, triangle numbers or samples are stored, or if samples are drawn over a picture.
  bool stores_blocks_;
  Reference one_color_reference_ = kNothing;
  std::uint32_t one_color_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
