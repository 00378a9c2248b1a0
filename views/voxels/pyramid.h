// Packed pictures of half the size, for coarser levels.
#pragma once

#include "views/voxels/packed_picture.h"

namespace glassbox::views {

// A pixel is the mean of those of its four that are the object's, and background only where all are. Nothing is hidden in it.
PackedPicture half_size(const PackedPicture& picture);

}  // namespace glassbox::views
