// From disparity to depth: Z = f B / (d + offset) (SPEC S2-13, C-114).
#pragma once

#include <optional>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

struct Principal {
  double x = 0, y = 0;  // px, from the picture's top left corner
};

struct Calibration {
  double focal_px = 0;
  double baseline =
      0;  // from camera to camera, below 0 where the right picture's stands to the left; depth has its unit
  double offset_px =
      0;  // the left principal point's x less the right one's, taken away from disparities: added before depth
  std::optional<Principal> principal = {};  // of the left camera; absent: the picture's centre
};
Principal principal_of(const Calibration& calibration, int width, int height);

// An error where a number is not finite, focal length or baseline is not above 0 (C-109), or their product is so small or so great that
// depths are no floats.
Result<void> check_calibration(const Calibration& calibration);

// Infinite where there is no disparity, where the rays do not meet before the cameras: (d + offset) B <= 0 (C-107), or where the depth
// would be 0 or infinite as a float, as with an enormous offset.
Image<float> depths_of(const Image<float>& disparity, const Calibration& calibration);

}  // namespace glassbox::views
