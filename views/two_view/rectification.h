// Rectification: turns both pictures about their centres so that epipolar lines become scan lines,
// the same in both (Fusiello, Trucco and Verri, Machine Vision and Applications 12, 2000).
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/two_view/triangulation.h"

namespace glassbox::views {

struct Rectification {
  Matrix3d intrinsic;    // of both new cameras, which have the same rotation
  Matrix3d left, right;  // rectified pixel = left * (x, y, 1)
  Matrix3d from_left;    // rotation from the left camera's space to that of the new cameras
  double baseline =
      0;  // > 0: the right camera is to the right, and disparities x_l - x_r are f B/Z

  // Shares of the old pictures' pixels that are outside of the new pictures, and of the new
  // pictures' pixels that show nothing.
  double lost_left = 0, lost_right = 0, empty_left = 0, empty_right = 0;
};

// For pictures of `width` x `height` pixels. Refused if an epipole is inside a picture: a camera
// that moves along its direction of view sees directions all around the epipole, and no picture
// with parallel epipolar lines can show them.
Result<Rectification> rectification_of(const StereoRig& rig, int width, int height);

// The picture by bilinear interpolation of its bytes; transparent black outside of the old picture.
Image<Rgba8> rectified(const Image<Rgba8>& picture, const Matrix3d& matrix);

}  // namespace glassbox::views
