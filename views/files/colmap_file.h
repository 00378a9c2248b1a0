// Cameras in COLMAP's formats: cameras.txt or cameras.bin has the lenses, images.txt or images.bin
// the place from which each picture was taken (colmap.github.io/format.html). Pixel coordinates are
// the same as here: the centre of the top left pixel is at (1/2, 1/2).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/files/camera_file.h"

namespace glassbox::views {

struct ColmapModel {
  std::vector<NamedCamera> cameras;  // sorted by the pictures' names, with the pictures' sizes
  std::vector<std::string> warnings;
};

// Refused: pictures whose lens does not exist or has distortion, missing numbers, focal lengths
// that are not positive, quaternions whose length is not 1 to within a tenth, and two pictures of
// one name. A quaternion of nearly unit length is made unit, with a warning where it is off by more
// than 1/1000. Lenses that no picture has are not looked at.
Result<ColmapModel> parse_colmap(std::string_view cameras, std::string_view images);

// As above. Counts in the files are not trusted: memory is taken only for what is there.
Result<ColmapModel> parse_colmap_binary(std::span<const std::byte> cameras,
                                        std::span<const std::byte> images);

}  // namespace glassbox::views
