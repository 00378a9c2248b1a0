// Packed pictures at half the size, for coarser levels.
#pragma once

#include "views/voxels/packed_picture.h"

namespace glassbox::views {

// A pixel is the mean of those of its four pixels that belong to the object. It is background only
// if all four are. No pixel is hidden.
PackedPicture half_size(const PackedPicture& picture);

}  // namespace glassbox::views
