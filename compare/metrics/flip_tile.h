// FLIP of one tile of a picture, including the pixels around the tile that its filters need (the
// halo).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <glassbox/compare/metrics/flip_filters.h>
#include <glassbox/compare/metrics/tiles.h>
#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

inline constexpr TileSize kLargestFlipTile{256, 64};
inline constexpr int kFlipHalo = std::max(kColourRadius, kFeatureRadius);  // px

// The samples of a tile with its halo on all sides. `kStride` is known to the compiler, so that the
// filter weights along y have fixed offsets.
class FlipPlane {
public:
  static constexpr std::ptrdiff_t kStride = kLargestFlipTile.width + 2 * kFlipHalo;
  static constexpr std::ptrdiff_t kRows = kLargestFlipTile.height + 2 * kFlipHalo;

  // Row y of the tile from its first pixel; the halo has negative indices and indices after the
  // tile's last.
  float* row(int y) { return samples_.data() + (y + kFlipHalo) * kStride + kFlipHalo; }
  const float* row(int y) const { return samples_.data() + (y + kFlipHalo) * kStride + kFlipHalo; }

private:
  std::array<float, std::size_t(kStride* kRows)> samples_;
};

// The planes of the opponent colours lightness, red-green and blue-yellow: see
// flip_colour::opponent_of_linear.
struct OpponentPlanes {
  FlipPlane lightness, red_green, blue_yellow;
};

// The tile as the eye sees it: colours in CIELab with Hunt's adjustment after filtering, and the
// strengths of edges and points.
struct PerceivedPlanes {
  FlipPlane lightness, a, b, edges, points;
};

// Computes the errors of tiles, one after the other. Each thread needs an object of its own, which
// takes 2 MB.
class FlipTile {
public:
  // Returns the box of the tile outside which all errors are exactly 0, and computes the errors in
  // it: row(0) ... row(box.height - 1) of error(). The tile is at most kLargestFlipTile.
  //
  // Outside the box, all samples that the filters reach are the same in both pictures, and so are
  // the bits of all intermediate results. Their differences are 0, and so are power(0, 0.7), the
  // colour error, and power(0, 1 - 0), the combined error.
  PixelBox compute(const PicturePair& pair, const PixelBox& tile);
  const FlipPlane& error() const { return error_; }

private:
  void compute_perceived(const PixelBox& tile, PerceivedPlanes& perceived);
  void compute_perceived_colours(const PixelBox& tile, PerceivedPlanes& perceived);
  void compute_features(const PixelBox& tile, PerceivedPlanes& perceived);
  // Replaces errors that are smaller than those between reference_ and test_.
  void raise_errors(const PixelBox& tile);

  OpponentPlanes opponent_;
  FlipPlane across_[3];  // filtered along x
  PerceivedPlanes reference_, test_;
  FlipPlane error_;
};

}  // namespace glassbox
