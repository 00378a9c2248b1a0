// Finds the part of a tile in which a metric can differ from its value for equal pictures.
#pragma once

#include <cstdint>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// Channels [first, first + count) of a picture.
struct ChannelRange {
  int first = 0;
  int count = 0;
};

// The smallest box around the pixels of `tile` that have a difference at most `reach` px away along
// each axis: a pixel that is compared and that does not have the same samples in both pictures. No
// other pixel of the tile changes if the test picture is replaced by the reference. Width and
// height are 0 if there is none.
PixelBox affected_box(const PicturePair& pair, const PixelBox& tile, int reach,
                      const ChannelRange& channels);

// The number of pixels in `box`, which is inside the picture, that are compared.
std::uint64_t compared_pixels(const Selection& selection, const PixelBox& box);

}  // namespace glassbox
