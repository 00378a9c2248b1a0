// Cameras in the file format of the Middlebury multi-view pictures (vision.middlebury.edu/mview):
// first the number of cameras, then a line for each: the picture's name, and K, R and t by rows, 21
// numbers. A world point X is at the pixel K (R X + t).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/decode.h>

#include "views/two_view/camera.h"

namespace glassbox::views {

struct NamedCamera {
  std::string picture;
  PinholeCamera camera;
  std::optional<ImageSize> size = {};  // of the picture, where the file has it; not in this format
};

// Refused: a number of cameras other than the first line says, a K that is singular or not upper
// triangular, and an R that mirrors, or that is no rotation to within the six digits of such files
// (entries of R^T R - I up to 1e-5).
Result<std::vector<NamedCamera>> parse_cameras(std::string_view text);
std::string cameras_text(const std::vector<NamedCamera>& cameras);

}  // namespace glassbox::views
