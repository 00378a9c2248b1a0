// Both pictures turned about their centres until epipolar lines are scan lines, the same in both (Fusiello, Trucco and Verri, Machine
// Vision and Applications 12, 2000).
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/two_view/triangulation.h"

namespace glassbox::views {

struct Rectification {
  Matrix3d intrinsic;    // of both new cameras, whose rotation is one and the same
  Matrix3d left, right;  // rectified pixel = left * (x, y, 1)
  Matrix3d from_left;    // rotation: of the new cameras, as the left one sees them
  double baseline =
      0;  // > 0: the right camera is to the right, and disparities x_l - x_r are f B/Z

  // Shares of the old pictures' pixels that the new ones have no place for, and of the new pictures' pixels that show nothing.
  double lost_left = 0, lost_right = 0, empty_left = 0, empty_right = 0;
};

// Of pictures of `width` x `height` pixels. Refused where an epipole lies in a picture: a camera that moves along its gaze sees every
// direction round it, which no picture with parallel lines shows.
Result<Rectification> rectification_of(const StereoRig& rig, int width, int height);

// The picture by bilinear interpolation of its bytes; transparent black where it shows nothing.
Image<Rgba8> rectified(const Image<Rgba8>& picture, const Matrix3d& matrix);

}  // namespace glassbox::views
