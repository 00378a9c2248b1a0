// Converts disparity to depth: Z = f B / (d + offset), with the depth Z, the focal length f in px,
// the distance B between the cameras and the disparity d in px (S2-13, C-114).
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
  // The distance between the cameras, negative if the right picture's camera is on the left; depths
  // have the same unit.
  double baseline = 0;
  // The right principal point's x minus the left one's. Disparities are too small by this
  // difference, so it is added to them before depth is computed.
  double offset_px = 0;
  std::optional<Principal> principal = {};  // of the left camera; absent: the picture's centre
};
Principal principal_of(const Calibration& calibration, int width, int height);

// An error if a number is not finite, if focal length or baseline is not above 0 (C-109), or if
// their product is so small or so large that depths are not floats.
Result<void> check_calibration(const Calibration& calibration);

// The depth is infinite where there is no disparity, where the rays do not meet in front of the
// cameras, that is, (d + offset) B <= 0 (C-107), and where it would be 0 or infinite as a float,
// for example with an enormous offset.
Image<float> depths_of(const Image<float>& disparity, const Calibration& calibration);

}  // namespace glassbox::views
