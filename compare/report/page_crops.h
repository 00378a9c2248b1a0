// Chooses the parts of a picture that a page shows: all of it, or crops around the differences.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

struct CropLimits {
  std::uint64_t whole_pixels = std::uint64_t(1)
                               << 24;  // pictures of up to this many pixels are shown whole
  int side = 1024;                     // px, of a crop
  std::size_t count = 8;
};

// Returns boxes inside a picture of width x height pixels: one box of the whole picture, or crops
// around the worst regions, each with its surroundings. If no difference is known (`differences`
// may be null), the crop is the top left corner.
std::vector<PixelBox> crops_of(int width, int height, const Differences* differences,
                               const CropLimits& limits);

}  // namespace glassbox
