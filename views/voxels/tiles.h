// Whole blocks of voxels that need not be looked up: those that fall on background, and those of which nothing can be seen.
//
// The pixels of a picture are counted in tiles of 4 x 4. Where all the tiles around the projection of a block are background, or
// hidden in every picture, so are all of its voxels, and their verdicts are what one after the other would have found.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "views/voxels/footprint.h"

namespace glassbox::views {

// Columns and rows of pixels, both ends included, not kept to any picture.
struct PixelRect {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
};

class PixelTiles {
public:
  explicit PixelTiles(const PackedPicture& picture);

  // What those of such a picture take.
  static double bytes_for(int width, int height);

  // A pixel is hidden that was not, and is no background.
  void hide(int column, int row);
  // Every voxel that falls into the rectangle is background here, or is seen by nobody here and is no background.
  bool is_background(const PixelRect& rect) const;
  bool is_hidden(const PixelRect& rect) const;

private:
  bool has_all(const std::vector<std::uint64_t>& bits, const PixelRect& inside) const;
  bool sticks_out(const PixelRect& rect) const;
  PixelRect kept_inside(const PixelRect& rect) const;

  int width_, height_, words_;  // tiles, and words of their bits in a row
  int pixels_wide_, pixels_high_;
  bool has_whole_;                  // beside the picture is background
  std::vector<std::uint8_t> left_;  // pixels of each tile that are open or background
  std::vector<std::uint64_t> background_, hidden_;  // one bit a tile: all of it
};

// A box of voxels, both ends included.
struct VoxelBox {
  VoxelAt low, high;
};

// A rectangle that has the pixel of every centre of the box, as floats find it (projected()); nothing where a centre is not before the
// camera, or the numbers are too large for that to be known.
std::optional<PixelRect> rect_of(const GridPicture& lens, const VoxelBox& box);

}  // namespace glassbox::views
