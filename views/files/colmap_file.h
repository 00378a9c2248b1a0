// Cameras in COLMAP's text format: cameras.txt has the lenses, images.txt the place from which each
// picture was taken (colmap.github.io/format.html). Pixel coordinates are the same as here: the
// centre of the top left pixel is at (1/2, 1/2).
#pragma once

#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/files/camera_file.h"

namespace glassbox::views {

// Sorted by the pictures' names. Refused: lenses with distortion, missing numbers, focal lengths
// that are not positive, quaternions whose length is not 1, a picture whose lens does not exist,
// and two pictures of one name.
Result<std::vector<NamedCamera>> parse_colmap(std::string_view cameras, std::string_view images);

}  // namespace glassbox::views
