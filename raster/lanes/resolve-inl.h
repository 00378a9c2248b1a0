// Resolves a tile: what is seen at its pixels becomes colours, distances and triangle numbers in
// the framebuffer. Each pixel is shaded once, however many triangles were drawn over it.

#if defined(GLASSBOX_RESOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_INL_H_
#undef GLASSBOX_RESOLVE_INL_H_
#else
#define GLASSBOX_RESOLVE_INL_H_
#endif

#include <algorithm>
#include <type_traits>

#include <hwy/cache_control.h>

#include <glassbox/raster/lanes/resolve_plain-inl.h>
#include <glassbox/raster/lanes/resolve_quad-inl.h>
#include <glassbox/raster/lanes/resolve_samples-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Resolves the tile block by block. There are faster functions for blocks that show few triangles.
template <class Channels>
class TileResolver {
public:
  TileResolver(const ResolveJob& job, std::span<TileBuffer> tiles)
      : job_(job),
        tiles_(tiles),
        tile_(tiles.front()),
        shades_blocks_(job.picture != nullptr && job.distance == nullptr && job.id == nullptr &&
                       job.points.empty() && job.samples == nullptr),
        rows_(job, tile_),
        shader_(job),
        plain_(job, tiles, rows_, shader_),
        quads_(job, tile_, rows_, shader_) {}

  void resolve() {
    if (plain_.is_constant_tile()) {
      const TileBlock& first = tile_.block(0);
      const PixelRect& window = tile_.window();
      rows_.stream_constant(plain_.color_of(first, window.x0, window.y0),
                            stored_code(first.nearest));
    } else {
      resolve_blocks();
    }
    hwy::FlushStream();
  }

private:
  void resolve_blocks() {
    const PixelRect& window = tile_.window();
    for (int y = window.y0; y < window.y1; y += kBlockSide) {
      rows_.begin_blocks(y);
      for (int x = window.x0; x < window.x1; x += kBlockSide) {
        const std::size_t block =
            tile_.block_index((x - window.x0) / kBlockSide, (y - window.y0) / kBlockSide);
        const bool is_on_screen = x + kBlockSide <= window.x1 && y + kBlockSide <= window.y1;
        if (is_on_screen && plain_.is_plain(block)) {
          plain_.resolve(block, x, y);
        } else if (is_on_screen && shades_blocks_ &&
                   (BlockOfTile(tile_, block, x, y).shows_few_triangles() ||
                    shader_.shows_texture(tile_, block))) {
          resolve_block(block, x, y);
        } else if (!job_.points.empty()) {
          resolve_samples(block, x, y);
        } else {
          resolve_quads(block, x, y);
        }
      }
      rows_.stream({window.x0, y, window.x1, std::min(y + kBlockSide, window.y1)}, tile_.side());
    }
  }

  // Resolves a block that is wholly on the screen, in a framebuffer that has one sample per pixel
  // and stores only colours and depths.
  HWY_NOINLINE void resolve_block(std::size_t block, int x, int y) {
    if (job_.depth != nullptr) {
      for (int quad = 0; quad < kBlockQuads; ++quad) {
        rows_.store_depths(block, quad, x + (quad % 2) * kQuadSide, y + (quad / 2) * kQuadSide);
      }
    }
    const TileBlock& b = tile_.block(block);
    const bool is_in_picture = b.reference == kNothing || b.reference == kInPicture;
    if (b.plain && is_in_picture && job_.keep_picture) return;
    Ints colors[kBlockVectors], seen[kBlockVectors];
    IntMask pending[kBlockVectors];
    rows_.load_colors(colors, x, y);
    for (std::size_t i = 0; i < kBlockVectors; ++i) {
      seen[i] = visible_references(tile_, block, int(i / kQuadVectors), i % kQuadVectors * kLanes);
      pending[i] = is_to_be_shaded(seen[i]);
    }
    shader_.shade_block(BlockOfTile(tile_, block, x, y), seen, pending, colors);
    rows_.store_colors(colors, x, y);
  }

  // Resolves a block with several samples per pixel. Only AllChannels is used then (resolve_tile in
  // kernels.cpp).
  HWY_INLINE void resolve_samples(std::size_t block, int x, int y) {
    if constexpr (std::is_same_v<Channels, AllChannels>) {
      SampleResolver(job_, tiles_, shader_).resolve(block, x, y, rows_.color());
    }
  }

  HWY_INLINE void resolve_quads(std::size_t block, int x, int y) {
    const PixelRect& window = tile_.window();
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
      if (qx < window.x1 && qy < window.y1) quads_.resolve(block, quad, qx, qy);
    }
  }

  const ResolveJob& job_;
  std::span<TileBuffer> tiles_;
  TileBuffer& tile_;    // the first of tiles_, or the only one
  bool shades_blocks_;  // whether a block's vectors may be shaded together
  TileRows rows_;
  VisibleShader<Channels> shader_;
  PlainBlockResolver<Channels> plain_;
  QuadResolver<Channels> quads_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
