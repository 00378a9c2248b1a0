// Resolves a tile: what is seen at its pixels becomes colours, distances and triangle numbers in
// the framebuffer. Each pixel is shaded once, however many triangles were drawn over it.

#if defined(GLASSBOX_RESOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_INL_H_
#undef GLASSBOX_RESOLVE_INL_H_
#else
#define GLASSBOX_RESOLVE_INL_H_
#endif

#include <algorithm>
#include <bit>

#include <hwy/cache_control.h>

#include <glassbox/raster/lanes/resolve_samples-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The pixels of a quad, row by row.
struct QuadPixels {
  HWY_ALIGN std::int32_t color[kQuadPixels];
  HWY_ALIGN float distance[kQuadPixels];
  HWY_ALIGN std::int32_t id[kQuadPixels];
};

template <class Channels>
class TileResolver {
public:
  TileResolver(const ResolveJob& job, std::span<TileBuffer> tiles)
      : job_(job),
        tiles_(tiles),
        tile_(tiles.front()),
        mask_(bytes_of(job.mask)),
        has_other_planes_(job.picture != nullptr || job.distance != nullptr || job.id != nullptr),
        plain_blocks_(job.distance == nullptr && job.id == nullptr && job.samples == nullptr &&
                      (!job.keep_picture || job.points.empty())),
        shades_blocks_(job.picture != nullptr && job.distance == nullptr && job.id == nullptr &&
                       job.points.empty() && job.samples == nullptr),
        streams_color_(job.picture != nullptr && job.samples == nullptr && !job.drawn_over &&
                       (!job.keep_picture || job.tile_colors != nullptr)),
        color_{tile_.color_rows(), tile_.side(), tile_.window().x0, tile_.window().y0},
        depth_{tile_.depth_rows(), tile_.side(), tile_.window().x0, tile_.window().y0},
        shader_(job) {
    if (job.tile_colors != nullptr) {
      color_.first = job.tile_colors;
    } else if (job.picture != nullptr && !streams_color_) {
      color_ = rows_of(*job.picture);
    }
  }

  void resolve() {
    if (is_one_block()) {
      fill_first_row();
      stream(tile_.window(), 0);
    } else {
      resolve_blocks();
    }
    hwy::FlushStream();
  }

private:
  // Whether the whole tile has one colour and one depth: nothing is seen, or one large triangle.
  bool is_one_block() const {
    const TileBlock& first = tile_.block(0);
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
  void fill_first_row() {
    const TileBlock& first = tile_.block(0);
    const PixelRect& window = tile_.window();
    std::fill_n(tile_.color_rows(), tile_.side(), color_of(first, window.x0, window.y0));
    std::fill_n(tile_.depth_rows(), tile_.side(), code_of(first));
  }

  // Writes the tile's completed rows to the picture.
  void stream(const PixelRect& rows, std::ptrdiff_t pitch) {
    if (streams_color_) {
      stream_rows(color_.at(rows.x0, rows.y0), pitch, rows, *job_.picture);
    }
    if (job_.depth != nullptr) stream_rows(tile_.depth_rows(), pitch, rows, *job_.depth);
  }

  void resolve_blocks() {
    const PixelRect& window = tile_.window();
    for (int y = window.y0; y < window.y1; y += kBlockSide) {
      if (streams_color_ && job_.tile_colors == nullptr) color_.y0 = y;
      depth_.y0 = y;
      for (int x = window.x0; x < window.x1; x += kBlockSide) {
        const std::size_t block =
            tile_.block_index((x - window.x0) / kBlockSide, (y - window.y0) / kBlockSide);
        if (is_plain(block) && x + kBlockSide <= window.x1 && y + kBlockSide <= window.y1) {
          resolve_plain_block(block, x, y);
          continue;
        }
        if (shades_blocks_ && x + kBlockSide <= window.x1 && y + kBlockSide <= window.y1 &&
            (BlockOfTile(tile_, block, x, y).shows_few() || shader_.shows_texture(tile_, block))) {
          resolve_block(block, x, y);
          continue;
        }
        if (!job_.points.empty()) {
          resolve_samples(block, x, y);
          continue;
        }
        for (int quad = 0; quad < kBlockQuads; ++quad) {
          const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
          if (qx < window.x1 && qy < window.y1) resolve_quad(block, quad, qx, qy);
        }
      }
      stream({window.x0, y, window.x1, std::min(y + kBlockSide, window.y1)}, tile_.side());
    }
  }

  // Whether the block shows only one triangle, or nothing, and all of its pixels are to be stored.
  bool is_plain(std::size_t block) const {
    const TileBlock& first = tile_.block(block);
    return first.plain && plain_blocks_ &&
           std::ranges::all_of(tiles_.subspan(1), [&](const TileBuffer& tile) {
             return tile.block(block).plain && tile.block(block).reference == first.reference;
           });
  }
  static bool shows_triangle(const TileBlock& b) {
    return b.reference != kNothing && b.reference != kInPicture;
  }
  // Whether the pixels of a plain block differ in colour.
  bool is_shaded(const TileBlock& b) const {
    return job_.picture != nullptr && shows_triangle(b) &&
           !job_.large[b.reference & ~kLargeReference]->one_color;
  }
  // Returns the one colour of a plain block at (x, y) whose pixels do not differ. One pixel is
  // shaded, and its colour is kept for the following blocks.
  std::uint32_t color_of(const TileBlock& b, int x, int y) {
    if (job_.picture == nullptr) return 0;
    if (!shows_triangle(b)) return std::bit_cast<std::uint32_t>(job_.background);
    if (b.reference != one_color_reference_) {
      one_color_reference_ = b.reference;
      one_color_ = color_at(b.reference, x, y);
    }
    return one_color_;
  }
  HWY_NOINLINE std::uint32_t color_at(Reference reference, int x, int y) {
    const LargeShape& shape = shader_.shape_of(reference);
    const LargeSource source(shape, x, y, 0, AtCentre());
    HWY_ALIGN std::int32_t colors[kLanes];
    const Ints shaded = encoded(
        shining_by_call<Channels>(job_.draws[shape.triangle->draw], DrawTextures(), job_, source),
        job_);
    store(over(shaded, std::bit_cast<std::int32_t>(job_.background)), colors);
    return std::uint32_t(colors[0]);
  }
  // The depth code of a plain block whose pixels all have the same depth.
  static std::uint32_t code_of(const TileBlock& b) { return stored_code(b.nearest); }

  // (A triangle that covers all samples of a pixel covers its centre too, which is between them.)
  HWY_INLINE void resolve_plain_block(std::size_t block, int x, int y) {
    const TileBlock& b = tile_.block(block);
    if (job_.depth != nullptr) store_plain_depths(block, x, y);
    if (job_.picture == nullptr) return;
    if (is_shaded(b)) {
      shade_plain_block(b, x, y);
    } else if (!job_.keep_picture) {
      fill_block_rows(color_, x, y, color_of(b, x, y));
    } else if (shows_triangle(b)) {
      Ints colors[kBlockVectors];
      std::fill_n(colors, kBlockVectors, Ints(std::int32_t(color_of(b, x, y))));
      lay_over(colors, x, y);
      store_colors(colors, x, y);
    }
  }
  HWY_NOINLINE void shade_plain_block(const TileBlock& b, int x, int y) {
    const LargeTriangle& triangle = *job_.large[b.reference & ~kLargeReference];
    const ShadeDraw& draw = job_.draws[triangle.draw];
    const DrawTextures textures(draw);
    Ints colors[kBlockVectors];
    const LargeShape& shape = shader_.shape_of(b.reference);
    shade_vectors<Channels, LargeSource>(
        draw, textures, job_, kBlockVectors,
        [&](std::size_t i) HWY_ATTR { return SeenShader<Channels>::large_source(shape, x, y, i); },
        colors);
    if (mask_ != -1) lay_over(colors, x, y);
    store_colors(colors, x, y);
  }
  // Takes the written channels from `color` and the others from `before`, the pixel's previous
  // value.
  HWY_INLINE Ints over(Ints color, Ints before) const {
    return (color & mask_) | (before & ~mask_);
  }
  HWY_NOINLINE void lay_over(Ints* colors, int x, int y) const {
    Ints before[kBlockVectors];
    take_colors(before, x, y);
    for (std::size_t i = 0; i < kBlockVectors; ++i) colors[i] = over(colors[i], before[i]);
  }
  HWY_INLINE void store_colors(const Ints* colors, int x, int y) {
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      HWY_ALIGN std::int32_t of_quad[kQuadPixels];
      for (std::size_t k = 0; k < kQuadVectors; ++k) {
        store(colors[std::size_t(quad) * kQuadVectors + k], of_quad + k * kLanes);
      }
      store_quad(of_quad, color_, tile_.window(), x + (quad % 2) * kQuadSide,
                 y + (quad / 2) * kQuadSide);
    }
  }

  HWY_INLINE static void fill_block_rows(const Rows& rows, int x, int y, std::uint32_t value) {
    const hn::CappedTag<std::uint32_t, kBlockSide> d;
    const auto words = hn::Set(d, value);
    std::uint32_t* to = rows.at(x, y);
    for (int row = 0; row < kBlockSide; ++row, to += rows.pitch) {
      for (std::size_t i = 0; i < kBlockSide; i += hn::Lanes(d)) hn::StoreU(words, d, to + i);
    }
  }

  HWY_NOINLINE void store_plain_depths(std::size_t block, int x, int y) {
    const TileBlock& b = tile_.block(block);
    if (b.triangle == nullptr) {
      fill_block_rows(depth_, x, y, code_of(b));
      return;
    }
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      HWY_ALIGN std::int32_t codes[kQuadPixels];
      fill_quad_depths(*b.triangle, tile_, x + (quad % 2) * kQuadSide, y + (quad / 2) * kQuadSide,
                       codes);
      store_quad(codes, depth_, tile_.window(), x + (quad % 2) * kQuadSide,
                 y + (quad / 2) * kQuadSide);
    }
  }

  // Resolves a block that is wholly on the screen, of a picture with one sample per pixel and no
  // planes other than its colours and depths.
  HWY_NOINLINE void resolve_block(std::size_t block, int x, int y) {
    if (job_.depth != nullptr) {
      for (int quad = 0; quad < kBlockQuads; ++quad) {
        store_depths(block, quad, x + (quad % 2) * kQuadSide, y + (quad / 2) * kQuadSide);
      }
    }
    const TileBlock& b = tile_.block(block);
    const bool is_in_picture = b.reference == kNothing || b.reference == kInPicture;
    if (b.plain && is_in_picture && job_.keep_picture) return;
    Ints colors[kBlockVectors], seen[kBlockVectors];
    IntMask pending[kBlockVectors];
    take_colors(colors, x, y);
    for (std::size_t i = 0; i < kBlockVectors; ++i) {
      seen[i] = seen_in(tile_, block, int(i / kQuadVectors), i % kQuadVectors * kLanes);
      pending[i] = is_to_be_shaded(seen[i]);
    }
    shader_.shade_block(BlockOfTile(tile_, block, x, y), seen, pending, colors);
    store_colors(colors, x, y);
  }

  // Sets `colors` to the colours that the block's pixels have before they are drawn.
  HWY_INLINE void take_colors(Ints* colors, int x, int y) const {
    if (!job_.keep_picture) {
      std::fill_n(colors, kBlockVectors, Ints(std::bit_cast<std::int32_t>(job_.background)));
      return;
    }
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      // g++ 14 cannot see that all entries are loaded.
      HWY_ALIGN std::int32_t of_quad[kQuadPixels] = {};
      load_quad(of_quad, color_, tile_.window(), x + (quad % 2) * kQuadSide,
                y + (quad / 2) * kQuadSide);
      for (std::size_t k = 0; k < kQuadVectors; ++k) {
        colors[std::size_t(quad) * kQuadVectors + k] = load(of_quad + k * kLanes);
      }
    }
  }

  // (A function of its own, like that of plain blocks: in one function compilers run out of
  // registers.)
  HWY_NOINLINE void resolve_quad(std::size_t block, int quad, int x, int y) {
    if (job_.depth != nullptr) store_depths(block, quad, x, y);
    const TileBlock& b = tile_.block(block);
    if (!has_other_planes_) return;
    const bool is_in_picture = b.reference == kNothing || b.reference == kInPicture;
    if (b.plain && is_in_picture && job_.keep_picture) return;
    QuadPixels pixels;
    if (job_.keep_picture) {
      take_from_picture(pixels, x, y);
    } else {
      clear(pixels);
    }
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      const Ints seen = seen_in(tile_, block, quad, k);
      shader_.shade_lanes(seen, is_to_be_shaded(seen), x, y, k, ToPixels{*this, pixels, k});
    }
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) store_quad(pixels.color, color_, window, x, y);
    if (job_.distance != nullptr)
      store_quad(pixels.distance, rows_of(*job_.distance), window, x, y);
    if (job_.id != nullptr) store_quad(pixels.id, rows_of(*job_.id), window, x, y);
  }

  // Resolves several samples per pixel, which resolve_tile shades in all channels.
  HWY_INLINE void resolve_samples(std::size_t block, int x, int y) {
    if constexpr (std::is_same_v<Channels, AllChannels>) {
      SampleResolver(job_, tiles_, shader_).resolve(block, x, y, color_);
    }
  }

  // A plain block whose depths differ is filled in first.
  HWY_INLINE void store_depths(std::size_t block, int quad, int x, int y) {
    if (tile_.block(block).triangle != nullptr) make_plain_block_full(tile_, block);
    const TileBlock& b = tile_.block(block);
    HWY_ALIGN std::int32_t codes[kQuadPixels];
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      const TileDepth* at =
          tile_.depth() + block * kBlockPixels + std::size_t(quad) * kQuadPixels + k;
      const Ints depth = b.plain ? Ints(b.nearest) : load(at);
      store(select(depth == kEmptyTileDepth, std::int32_t(kEmptyDepth), depth), codes + k);
    }
    store_quad(codes, depth_, tile_.window(), x, y);
  }

  HWY_INLINE void clear(QuadPixels& pixels) const {
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      store(std::bit_cast<std::int32_t>(job_.background), pixels.color + k);
      store(std::numeric_limits<float>::infinity(), pixels.distance + k);
      store(0, pixels.id + k);
    }
  }

  HWY_INLINE void take_from_picture(QuadPixels& pixels, int x, int y) const {
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) load_quad(pixels.color, color_, window, x, y);
    if (job_.distance != nullptr) load_quad(pixels.distance, rows_of(*job_.distance), window, x, y);
    if (job_.id != nullptr) load_quad(pixels.id, rows_of(*job_.id), window, x, y);
  }

  // Where in its pixel a fragment is shaded, and where the result is stored.
  struct ToPixels {
    HWY_INLINE AtCentre place(IntMask) const { return {}; }
    template <class Source>
    HWY_INLINE void take(const ShadeDraw& draw, const DrawTextures& textures, const Source& source,
                         IntMask lanes) const {
      resolver.finish(draw, textures, source, lanes, k, pixels);
    }
    TileResolver& resolver;
    QuadPixels& pixels;
    std::size_t k;
  };
  template <class Source>
  HWY_INLINE void finish(const ShadeDraw& draw, const DrawTextures& textures, const Source& source,
                         IntMask lanes, std::size_t k, QuadPixels& pixels) {
    if (job_.picture != nullptr) {
      const Ints before = load(pixels.color + k);
      const Ints color = over(shade<Channels>(draw, textures, job_, source), before);
      store(select(lanes, color, before), pixels.color + k);
    }
    if (job_.distance != nullptr) {
      const Floats distance = distance_of(job_, source.depth(), source.at().inverse_w);
      store(select(float_mask(lanes), distance, load(pixels.distance + k)), pixels.distance + k);
    }
    if (job_.id != nullptr) {
      store(select(lanes, source.id(), load(pixels.id + k)), pixels.id + k);
    }
  }

  const ResolveJob& job_;
  std::span<TileBuffer> tiles_;
  TileBuffer& tile_;  // the first of them, or the only one
  std::int32_t mask_;
  bool has_other_planes_;
  bool plain_blocks_;   // may be stored without reading what their pixels have in other planes
  bool shades_blocks_;  // as a whole, if their vectors have something in common
  bool streams_color_;
  Rows color_, depth_;
  SeenShader<Channels> shader_;
  Reference one_color_reference_ = kNothing;
  std::uint32_t one_color_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
