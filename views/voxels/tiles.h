// Finds blocks of voxels that need no look-up, because they are entirely background or entirely
// hidden.
//
// A picture's pixels are grouped in tiles of 4 x 4. If all tiles around a block's projection are
// background in one picture, all voxels of the block are background; if they are hidden in every
// picture, all voxels of the block are hidden. These are the verdicts that the look-up of each
// voxel would have given.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "views/voxels/footprint.h"

namespace glassbox::views {

// The pixels of columns left .. right and rows top .. bottom, both ends included; the rectangle may
// extend beyond the picture.
struct PixelRect {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
};

class PixelTiles {
public:
  explicit PixelTiles(const PackedPicture& picture);

  // Bytes for the tiles of a picture of this size.
  static double bytes_for(int width, int height);

  // To be called when a pixel becomes hidden that was neither hidden nor background.
  void hide(int column, int row);
  // is_background(): every voxel that is projected into the rectangle is background in this
  // picture. is_hidden(): every such voxel is hidden in this picture, and not background.
  bool is_background(const PixelRect& rect) const;
  bool is_hidden(const PixelRect& rect) const;

private:
  bool has_all(const std::vector<std::uint64_t>& bits, const PixelRect& inside) const;
  bool is_partly_outside(const PixelRect& rect) const;
  PixelRect clipped_to_picture(const PixelRect& rect) const;

  int width_, height_, words_;  // number of tiles, and of words for their bits in a row
  int pixels_wide_, pixels_high_;
  bool shows_whole_object_;         // everything outside of the picture is background
  std::vector<std::uint8_t> left_;  // pixels of each tile that are visible or background
  // one bit for each tile: set if all of its pixels are background, or hidden
  std::vector<std::uint64_t> background_, hidden_;
};

// A box of voxels from `low` to `high`, both included.
struct VoxelBox {
  VoxelPosition low, high;
};

// A rectangle that contains the pixels of all centres of the box, as computed in float
// (projected()). None if a centre is not in front of the camera, or if the numbers are too large
// for a guarantee.
std::optional<PixelRect> rect_of(const GridPicture& lens, const VoxelBox& box);

}  // namespace glassbox::views
