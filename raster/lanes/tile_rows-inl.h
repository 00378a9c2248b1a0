// Stores a tile's resolved colours and depth codes, and copies them to the picture.

#if defined(GLASSBOX_TILE_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_TILE_ROWS_INL_H_
#undef GLASSBOX_TILE_ROWS_INL_H_
#else
#define GLASSBOX_TILE_ROWS_INL_H_
#endif

#include <algorithm>
#include <bit>

#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/rows-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

inline std::uint32_t stored_code(TileDepth depth) {
  return depth == kEmptyTileDepth ? kEmptyDepth : std::uint32_t(depth);
}

// Takes the channels of `mask` from `color` and the other channels from `before`, the pixel's
// previous colour.
HWY_INLINE Ints merged_channels(Ints color, Ints before, std::int32_t mask) {
  return (color & mask) | (before & ~mask);
}

class TileRows {
public:
  TileRows(const ResolveJob& job, TileBuffer& tile)
      : job_(job),
        tile_(tile),
        streams_color_(job.picture != nullptr && job.samples == nullptr && !job.drawn_over &&
                       (!job.keep_picture || job.tile_colors != nullptr)),
        color_{tile.color_rows(), tile.side(), tile.window().x0, tile.window().y0},
        depth_{tile.depth_rows(), tile.side(), tile.window().x0, tile.window().y0} {
    if (job.tile_colors != nullptr) {
      color_.first = job.tile_colors;
    } else if (job.picture != nullptr && !streams_color_) {
      color_ = rows_of(*job.picture);
    }
  }

  const Rows& color() const { return color_; }

  // Prepares for storing the blocks whose first row is y: the tile has memory for only one row of
  // blocks.
  void begin_blocks(int y) {
    if (streams_color_ && job_.tile_colors == nullptr) color_.y0 = y;
    depth_.y0 = y;
  }

  // Writes the whole tile: one colour and one depth.
  void stream_constant(std::uint32_t color, std::uint32_t code) {
    std::fill_n(tile_.color_rows(), tile_.side(), color);
    std::fill_n(tile_.depth_rows(), tile_.side(), code);
    stream(tile_.window(), 0);
  }
  // Writes completed rows, `pitch` words apart in the tile, to the picture.
  void stream(const PixelRect& rows, std::ptrdiff_t pitch) {
    if (streams_color_) {
      stream_rows(color_.at(rows.x0, rows.y0), pitch, rows, *job_.picture);
    }
    if (job_.depth != nullptr) stream_rows(tile_.depth_rows(), pitch, rows, *job_.depth);
  }

  // ---- colours of a block that is wholly on the screen ----

  // Sets `colors` to the colours that the block's pixels have before they are drawn.
  HWY_INLINE void load_colors(Ints* colors, int x, int y) const {
    if (!job_.keep_picture) {
      std::fill_n(colors, kBlockVectors, Ints(std::bit_cast<std::int32_t>(job_.background)));
      return;
    }
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      // The array is initialised, because g++ 14 cannot see that all entries are loaded.
      HWY_ALIGN std::int32_t of_quad[kQuadPixels] = {};
      load_quad(of_quad, color_, tile_.window(), x + (quad % 2) * kQuadSide,
                y + (quad / 2) * kQuadSide);
      for (std::size_t k = 0; k < kQuadVectors; ++k) {
        colors[std::size_t(quad) * kQuadVectors + k] = load(of_quad + k * kLanes);
      }
    }
  }
  HWY_INLINE void store_colors(const Ints* colors, int x, int y) const {
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      HWY_ALIGN std::int32_t of_quad[kQuadPixels];
      for (std::size_t k = 0; k < kQuadVectors; ++k) {
        store(colors[std::size_t(quad) * kQuadVectors + k], of_quad + k * kLanes);
      }
      store_quad(of_quad, color_, tile_.window(), x + (quad % 2) * kQuadSide,
                 y + (quad / 2) * kQuadSide);
    }
  }
  HWY_INLINE void fill_colors(std::uint32_t color, int x, int y) const {
    fill_block(color_, color, x, y);
  }

  // ---- depth codes ----

  // Stores the depth codes of a plain block that is wholly on the screen. The block stays plain.
  HWY_NOINLINE void store_plain_depths(std::size_t block, int x, int y) const {
    const TileBlock& b = tile_.block(block);
    if (b.triangle == nullptr) {
      fill_block(depth_, stored_code(b.nearest), x, y);
      return;
    }
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      HWY_ALIGN std::int32_t codes[kQuadPixels];
      const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
      fill_quad_depths(*b.triangle, tile_, qx, qy, codes);
      store_quad(codes, depth_, tile_.window(), qx, qy);
    }
  }
  // Stores the depth codes of a quad. If its block is plain and the block's depths differ, the
  // block's pixels are computed first.
  HWY_INLINE void store_depths(std::size_t block, int quad, int x, int y) const {
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

private:
  HWY_INLINE static void fill_block(const Rows& rows, std::uint32_t value, int x, int y) {
    const hn::CappedTag<std::uint32_t, kBlockSide> d;
    const auto words = hn::Set(d, value);
    std::uint32_t* to = rows.at(x, y);
    for (int row = 0; row < kBlockSide; ++row, to += rows.pitch) {
      for (std::size_t i = 0; i < kBlockSide; i += hn::Lanes(d)) hn::StoreU(words, d, to + i);
    }
  }

  const ResolveJob& job_;
  TileBuffer& tile_;
  bool streams_color_;  // copies colours by whole rows, from the tile's memory
  Rows color_, depth_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
