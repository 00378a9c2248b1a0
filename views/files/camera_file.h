// Cameras in a file, as the Middlebury multi-view pictures have them (vision.middlebury.edu/mview): the number of cameras, then for
// each a line of a picture's name, K, R and t by rows, 21 numbers: a world point X is at the pixel K (R X + t).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/two_view/camera.h"

namespace glassbox::views {

struct NamedCamera {
  std::string picture;
  PinholeCamera camera;
};

// Refused: counts that do not agree, a K that is singular or not upper triangular, an R that is no rotation, within the six digits
// that such files have (entries of R^T R - I up to 1e-5), or a mirror.
Result<std::vector<NamedCamera>> parse_cameras(std::string_view text);
std::string cameras_text(const std::vector<NamedCamera>& cameras);

}  // namespace glassbox::views
