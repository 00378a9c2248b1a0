// A tile of the screen while it is drawn: small enough to stay in the cache of the core that draws
// it.
//
// It stores what is seen at one point of each pixel: the centre, or one of the pixel's samples
// (then there is a buffer for each sample).
//
// Pixels are stored in blocks of 8 x 8, each of four quads of 4 x 4. So a quad's 16 pixels are one
// vector on the widest processors and several vectors on the others.
//
// A block is `plain` if one triangle covers it wholly, in front of all that was there. It stores
// the triangle's reference and the range of its depths; its pixels are stored only when something
// else is drawn into the block, or when they are needed one by one. A cleared block is plain too,
// with the reference kNothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>

#include <glassbox/raster/depth.h>
#include <glassbox/raster/samples.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

inline constexpr int kQuadSide = 4, kQuadPixels = 16;
inline constexpr int kBlockSide = 8, kBlockPixels = 64, kBlockQuads = 4;

// ---- what is seen at a pixel ----

// Identifies the triangle seen at a pixel. Small triangles are numbered from 1 through all draws,
// in steps of kReferenceStep. The remainder of a step gives the order in which the setup has the
// triangle's vertices (setup-inl.h), so that shading need not compute it again. Large triangles
// have the top bit set.
using Reference = std::uint32_t;
inline constexpr Reference kNothing = 0;
inline constexpr Reference kReferenceStep = 8;
inline constexpr Reference kLargeReference = 0x80000000u;
inline constexpr Reference kInPicture = 0xffffffffu;  // the picture has the pixel's colour already

// Depth codes (depth.h) as signed integers, because some processors have no unsigned comparisons.
using TileDepth = std::int32_t;
inline constexpr TileDepth kNearestTileDepth = 0;
inline constexpr TileDepth kEmptyTileDepth = std::numeric_limits<TileDepth>::max();

// ---- memory ----

template <class T>
class AlignedArray {
public:
  // Different versions of clang-format put different spaces around these operators.
  // clang-format off
  explicit AlignedArray(std::size_t size) : data_(new(std::align_val_t{kAlignment}) T[size]) {}
  // clang-format on
  T* get() { return data_.get(); }
  const T* get() const { return data_.get(); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

private:
  // In bytes: the size of the longest vectors, and of a cache line.
  static constexpr std::size_t kAlignment = 64;
  struct Free {
    void operator()(T* data) const { ::operator delete[](data, std::align_val_t{kAlignment}); }
  };
  std::unique_ptr<T[], Free> data_;
};

struct TileBlock {
  TileDepth nearest = kEmptyTileDepth;   // no pixel of the block is nearer than this
  TileDepth farthest = kEmptyTileDepth;  // no pixel of the block is farther than this
  bool plain = true;
  // The triangle that covers a plain block, and the setup that its depths come from; null if all
  // pixels have the same depth.
  Reference reference = kNothing;
  const TriangleSetup* triangle = nullptr;
  // How many small triangles were drawn into the block (BlockTriangles), including triangles that
  // are hidden by now. It is kTooMany if there are more than kMost, or if one of them was tiny.
  std::uint32_t listed = 0;
};

// The small triangles that were drawn into a block, if they are few.
struct BlockTriangles {
  static constexpr std::uint32_t kMost = 16, kTooMany = kMost + 1;
  // Entries start at 1, in the order of drawing. Entry 0 is always empty. All triangles after the
  // first kMost are written to the last entry.
  Reference references[kTooMany + 1] = {};
};

class TileBuffer {
public:
  // The tile has `side` x `side` pixels: a power of two, at least kBlockSide.
  explicit TileBuffer(int side)
      : side_(side),
        blocks_across_(side / kBlockSide),
        depth_(std::size_t(side) * std::size_t(side)),
        reference_(std::size_t(side) * std::size_t(side)),
        color_rows_(std::size_t(side) * kBlockSide),
        depth_rows_(std::size_t(side) * kBlockSide),
        blocks_(std::size_t(blocks_across_) * std::size_t(blocks_across_)),
        listed_(std::size_t(blocks_across_) * std::size_t(blocks_across_)) {
    std::fill_n(listed_.get(), block_count(), BlockTriangles{});
  }

  // Begins the tile whose part of the screen is `window`; x0 and y0 are multiples of the side.
  // Coverage and depth of a pixel are computed at `point`.
  void clear(const PixelRect& window, DepthFormat format, SampleOffset point = {}) {
    window_ = window;
    format_ = format;
    point_ = point;
    farthest_ = kEmptyTileDepth;
    std::fill_n(blocks_.get(), block_count(), TileBlock{});
  }

  const PixelRect& window() const { return window_; }
  int side() const { return side_; }
  DepthFormat format() const { return format_; }
  SampleOffset point() const { return point_; }
  // Whether pixels of the tile are outside the screen.
  bool is_partly_off_screen() const {
    return window_.x1 - window_.x0 < side_ || window_.y1 - window_.y0 < side_;
  }
  int blocks_across() const { return blocks_across_; }
  std::size_t block_count() const {
    return std::size_t(blocks_across_) * std::size_t(blocks_across_);
  }

  // The index of the block at column bx, row by of the tile.
  std::size_t block_index(int bx, int by) const {
    return std::size_t(by) * std::size_t(blocks_across_) + std::size_t(bx);
  }
  // The index of the first pixel of the quad at column qx, row qy of the tile.
  std::size_t quad_index(int qx, int qy) const {
    return block_index(qx >> 1, qy >> 1) * kBlockPixels +
           std::size_t((qy & 1) * 2 + (qx & 1)) * kQuadPixels;
  }
  // The index of the pixel (x, y) of the screen.
  std::size_t pixel_index(int x, int y) const {
    const int dx = x - window_.x0, dy = y - window_.y0;
    return quad_index(dx / kQuadSide, dy / kQuadSide) +
           std::size_t((dy % kQuadSide) * kQuadSide + dx % kQuadSide);
  }

  // No pixel of the tile is farther than this.
  TileDepth farthest() const { return farthest_; }
  void lower_farthest(TileDepth depth) { farthest_ = std::min(farthest_, depth); }

  TileBlock& block(std::size_t i) { return blocks_[i]; }
  const TileBlock& block(std::size_t i) const { return blocks_[i]; }
  BlockTriangles& listed(std::size_t block) { return listed_[block]; }
  const BlockTriangles& listed(std::size_t block) const { return listed_[block]; }
  TileDepth* depth() { return depth_.get(); }
  const TileDepth* depth() const { return depth_.get(); }
  Reference* reference() { return reference_.get(); }
  const Reference* reference() const { return reference_.get(); }

  // Memory for a row of blocks in the layout of the picture: kBlockSide rows of `side` pixels.
  std::uint32_t* color_rows() { return color_rows_.get(); }
  std::uint32_t* depth_rows() { return depth_rows_.get(); }

private:
  int side_, blocks_across_;
  PixelRect window_;
  DepthFormat format_ = DepthFormat::kFloat32;
  SampleOffset point_;
  TileDepth farthest_ = kEmptyTileDepth;
  AlignedArray<TileDepth> depth_;
  AlignedArray<Reference> reference_;
  AlignedArray<std::uint32_t> color_rows_, depth_rows_;
  AlignedArray<TileBlock> blocks_;
  AlignedArray<BlockTriangles> listed_;
};

}  // namespace glassbox
