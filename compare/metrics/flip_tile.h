// FLIP of one tile of a picture, with what lies around the tile as far as its filters reach.
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

// Room for a tile with its halo on all sides. `kStride` is known to the compiler, so that taps along y have fixed
// places.
class FlipPlane {
public:
  static constexpr std::ptrdiff_t kStride = kLargestFlipTile.width + 2 * kFlipHalo;
  static constexpr std::ptrdiff_t kRows = kLargestFlipTile.height + 2 * kFlipHalo;

  // Row y of the tile from its first pixel; the halo lies at negative places and behind the tile.
  float* row(int y) { return samples_.data() + (y + kFlipHalo) * kStride + kFlipHalo; }
  const float* row(int y) const { return samples_.data() + (y + kFlipHalo) * kStride + kFlipHalo; }

private:
  std::array<float, std::size_t(kStride* kRows)> samples_;
};

// Lightness, red against green, blue against yellow: flip_colour::opponent_of_linear.
struct OpponentPlanes {
  FlipPlane lightness, red_green, blue_yellow;
};

// What an eye makes of the tile: colours in CIELab with Hunt's adjustment after filtering, and the strengths of edges
// and points.
struct SeenPlanes {
  FlipPlane lightness, a, b, edges, points;
};

// The errors of tiles, one after the other; a thread needs one of these, of 2 MB.
class FlipTile {
public:
  // Fills error().row(0) ... row(tile.height - 1). The tile is at most kLargestFlipTile.
  void compute(const PicturePair& pair, const PixelBox& tile);
  const FlipPlane& error() const { return error_; }

private:
  void see(const PixelBox& tile, SeenPlanes& seen);
  void see_colours(const PixelBox& tile, SeenPlanes& seen);
  void see_features(const PixelBox& tile, SeenPlanes& seen);

  OpponentPlanes opponent_;
  FlipPlane across_[3];  // filtered along x
  SeenPlanes reference_, test_;
  FlipPlane error_;
};

}  // namespace glassbox
