// A tile of the screen while it is drawn: small enough to stay in the cache of the core that draws it.
//
// It has one point of each pixel: the centre, or one of the pixel's samples, of which each has a buffer of its own.
//
// Pixels are kept in blocks of 8 x 8, each of four quads of 4 x 4, so that a quad's 16 pixels are one vector of the widest
// processors and some of them a vector of the others.
//
// A block that one triangle covers wholly, in front of all that was there, is `plain`: it keeps the triangle's reference and
// the range of its depths, and its pixels are filled in only when something else comes to the block. A cleared block is such a block
// too, of the reference kNothing.
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

// Small triangles count from 1 through all draws, in steps of kReferenceStep; what is left of a step says in which order the
// setup has the triangle's vertices (setup-inl.h), so that shading need not find it again. Large triangles have the top bit set.
using Reference = std::uint32_t;
inline constexpr Reference kNothing = 0;
inline constexpr Reference kReferenceStep = 8;
inline constexpr Reference kLargeReference = 0x80000000u;
inline constexpr Reference kInPicture = 0xffffffffu;  // the picture has its colour already

// Depth codes (depth.h) as signed integers, which processors without unsigned comparisons compare as well.
using TileDepth = std::int32_t;
inline constexpr TileDepth kNearestTileDepth = 0;
inline constexpr TileDepth kEmptyTileDepth = std::numeric_limits<TileDepth>::max();

// ---- memory ----

template <class T>
class AlignedArray {
public:
  // Versions of clang-format put other blanks around these operators.
  // clang-format off
  explicit AlignedArray(std::size_t size) : data_(new(std::align_val_t{kAlignment}) T[size]) {}
  // clang-format on
  T* get() { return data_.get(); }
  const T* get() const { return data_.get(); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

private:
  // Bytes: the longest vectors, and a line of the cache.
  static constexpr std::size_t kAlignment = 64;
  struct Free {
    void operator()(T* data) const { ::operator delete[](data, std::align_val_t{kAlignment}); }
  };
  std::unique_ptr<T[], Free> data_;
};

struct TileBlock {
  TileDepth nearest = kEmptyTileDepth;   // no pixel of the block is nearer ...
  TileDepth farthest = kEmptyTileDepth;  // ... or farther
  bool plain = true;
  // What covers a plain block, and the triangle that its depths come from; null where all have the same.
  Reference reference = kNothing;
  const TriangleSetup* triangle = nullptr;
  // How many small triangles came to the block, those that large ones hid since included; kTooMany also where one of them was tiny.
  std::uint32_t listed = 0;
};

// Which small triangles came to a block, as long as they are few.
struct BlockTriangles {
  static constexpr std::uint32_t kMost = 16, kTooMany = kMost + 1;
  // From 1 on, in the order in which they came. 0 is none, and stays so; the last is any of those that are too many.
  Reference references[kTooMany + 1] = {};
};

class TileBuffer {
public:
  // `side` pixels: a power of two, at least kBlockSide.
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

  // Begins the tile whose part of the screen is `window`; x0 and y0 are multiples of the side. Whether a pixel is covered is
  // asked at `point`, and so is its depth.
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
  // Pixels of the tile lie outside of the screen.
  bool is_ragged() const {
    return window_.x1 - window_.x0 < side_ || window_.y1 - window_.y0 < side_;
  }
  int blocks_across() const { return blocks_across_; }
  std::size_t block_count() const {
    return std::size_t(blocks_across_) * std::size_t(blocks_across_);
  }

  // Where the block at column bx, row by of the tile is stored.
  std::size_t block_index(int bx, int by) const {
    return std::size_t(by) * std::size_t(blocks_across_) + std::size_t(bx);
  }
  // Where the first pixel of the quad at column qx, row qy of the tile is stored.
  std::size_t quad_index(int qx, int qy) const {
    return block_index(qx >> 1, qy >> 1) * kBlockPixels +
           std::size_t((qy & 1) * 2 + (qx & 1)) * kQuadPixels;
  }
  // Where the pixel (x, y) of the screen is stored.
  std::size_t pixel_index(int x, int y) const {
    const int dx = x - window_.x0, dy = y - window_.y0;
    return quad_index(dx / kQuadSide, dy / kQuadSide) +
           std::size_t((dy % kQuadSide) * kQuadSide + dx % kQuadSide);
  }

  // No pixel of the tile is farther.
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

  // A row of blocks as it leaves for the picture: kBlockSide rows of `side` pixels.
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
