// Cameras as COLMAP's text format has them: cameras.txt with the lenses, images.txt with where each picture was taken
// (colmap.github.io/format.html). Its pixels are ours: the centre of the top left one is at (1/2, 1/2).
#pragma once

#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/files/camera_file.h"

namespace glassbox::views {

// In the order of the pictures' names. Refused: lenses that are distorted, numbers that are missing, focal lengths that are not
// positive, quaternions that are none, a picture of a lens that does not exist, and two pictures of one name.
Result<std::vector<NamedCamera>> parse_colmap(std::string_view cameras, std::string_view images);

}  // namespace glassbox::views
