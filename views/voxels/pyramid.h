// Packed pictures at half the size, for coarser levels.
#pragma once

#include "views/voxels/packed_picture.h"

namespace glassbox::views {

// A pixel of the result covers four pixels of the picture; it is the mean of those that belong to
// the object, and background only if all four are. No pixel of the result is marked as hidden.
PackedPicture half_size(const PackedPicture& picture);

}  // namespace glassbox::views
