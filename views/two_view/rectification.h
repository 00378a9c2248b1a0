// Rectification: turns both cameras about their centres so that epipolar lines become scan lines,
// and matching points are in the same line of both pictures (Fusiello, Trucco and Verri, Machine
// Vision and Applications 12, 2000).
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/two_view/triangulation.h"

namespace glassbox::views {

struct Rectification {
  Matrix3d intrinsic;    // K of both new cameras, which have the same rotation
  Matrix3d left, right;  // homographies: the rectified left pixel is left * (x, y, 1)
  Matrix3d from_left;    // rotation from the left camera's space to that of the new cameras
  // B, above 0 if the right camera is to the right. A point at depth Z has the disparity
  // x_l - x_r = f B/Z, with the focal length f.
  double baseline = 0;

  // Fractions: how much of each old picture is outside of the new picture (lost), and how much of
  // each new picture shows nothing (empty).
  double lost_left = 0, lost_right = 0, empty_left = 0, empty_right = 0;
};

// For pictures of `width` x `height` pixels. An error if an epipole is inside a picture: a camera
// that moves along its direction of view sees directions all around the epipole, and no picture
// with parallel epipolar lines can show them.
Result<Rectification> rectification_of(const StereoRig& rig, int width, int height);

// The picture transformed by `matrix`, by bilinear interpolation of its bytes; transparent black
// where the old picture has nothing.
Image<Rgba8> rectified(const Image<Rgba8>& picture, const Matrix3d& matrix);

}  // namespace glassbox::views
