#include "views/two_view/rectification.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace glassbox::views {

namespace {

bool is_inside(const Vector2d& pixel, int width, int height) {
  return pixel.x() >= 0 && pixel.x() <= width && pixel.y() >= 0 && pixel.y() <= height;
}

// Whether the ray in this direction, or in the opposite one, passes through the picture.
bool shows(const Matrix3d& intrinsic, const Vector3d& direction, int width, int height) {
  if (direction.z() == 0) return false;
  return is_inside((intrinsic * direction).hnormalized(), width, height);
}

// The fraction of a picture's pixel centres that `matrix` moves out of the picture.
double share_outside(const Matrix3d& matrix, int width, int height) {
  std::int64_t outside = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vector3d at = matrix * Vector3d(x + 0.5, y + 0.5, 1);
      outside += at.z() <= 0 || !is_inside(at.hnormalized(), width, height);
    }
  }
  return double(outside) / (double(width) * double(height));
}

Matrix3d of_positive_scale(const Matrix3d& homography, int width, int height) {
  const Vector3d centre(width / 2.0, height / 2.0, 1);
  return (homography * centre).z() < 0 ? Matrix3d(-homography) : homography;
}

}  // namespace

// The new cameras' x axis is along the baseline, and their z axis is as near as possible to the
// mean of both directions of view.
Result<Rectification> rectification_of(const StereoRig& rig, int width, int height) {
  const Vector3d baseline = rig.pose.translation;
  if (baseline.norm() == 0) {
    return fail("the cameras", "both are at the same place, so there are no epipolar lines",
                "use pictures from two places");
  }
  const bool in_left = shows(rig.left_intrinsic, baseline, width, height);
  const bool in_right = shows(rig.right_intrinsic, rig.pose.rotation * baseline, width, height);
  if (in_left || in_right) {
    return fail("the cameras",
                "one camera sees the other in its picture: the epipolar lines meet in a point, and "
                "cannot be made parallel",
                "use pictures from places beside each other");
  }
  const double sign = baseline.x() < 0 ? -1 : 1;
  const Vector3d gaze =
      (Vector3d::UnitZ() + rig.pose.rotation.transpose() * Vector3d::UnitZ()).normalized();
  const Vector3d x = sign * baseline.normalized();
  const Vector3d y = gaze.cross(x).normalized();
  const Vector3d z = x.cross(y);

  Rectification result;
  result.baseline = sign * baseline.norm();
  result.from_left << x.transpose(), y.transpose(), z.transpose();
  const double focal = (rig.left_intrinsic(1, 1) + rig.right_intrinsic(1, 1)) / 2;
  result.intrinsic << focal, 0, width / 2.0, 0, focal, height / 2.0, 0, 0, 1;
  const auto homographies = [&] {
    result.left = of_positive_scale(
        result.intrinsic * result.from_left * rig.left_intrinsic.inverse(), width, height);
    result.right =
        of_positive_scale(result.intrinsic * result.from_left * rig.pose.rotation.transpose() *
                              rig.right_intrinsic.inverse(),
                          width, height);
  };
  homographies();
  // The mean of the places to which the middles of both old pictures are moved becomes the middle
  // of the new pictures. The shift is the same for both pictures, so disparities do not change.
  const Vector3d centre(width / 2.0, height / 2.0, 1);
  const Vector2d middle =
      ((result.left * centre).hnormalized() + (result.right * centre).hnormalized()) / 2;
  result.intrinsic.col(2).head<2>() += centre.head<2>() - middle;
  homographies();

  result.lost_left = share_outside(result.left, width, height);
  result.lost_right = share_outside(result.right, width, height);
  result.empty_left = share_outside(result.left.inverse(), width, height);
  result.empty_right = share_outside(result.right.inverse(), width, height);
  return result;
}

namespace {

// The colour at a place between pixel centres, interpolated from the four pixels around it.
Rgba8 sample_between(const Image<Rgba8>& picture, const Vector2d& at) {
  const double x = std::clamp(at.x() - 0.5, 0.0, picture.width - 1.0);
  const double y = std::clamp(at.y() - 0.5, 0.0, picture.height - 1.0);
  const int left = std::min(int(x), std::max(0, picture.width - 2));
  const int top = std::min(int(y), std::max(0, picture.height - 2));
  const int right = std::min(left + 1, picture.width - 1);
  const int bottom = std::min(top + 1, picture.height - 1);
  const double across = x - left, down = y - top;
  using Channel = std::uint8_t Rgba8::*;
  const auto mixed = [&](Channel channel) {
    const double upper =
        picture.at(left, top).*channel * (1 - across) + picture.at(right, top).*channel * across;
    const double lower = picture.at(left, bottom).*channel * (1 - across) +
                         picture.at(right, bottom).*channel * across;
    return std::uint8_t(std::lround(upper * (1 - down) + lower * down));
  };
  return {mixed(&Rgba8::r), mixed(&Rgba8::g), mixed(&Rgba8::b), mixed(&Rgba8::a)};
}

}  // namespace

Image<Rgba8> rectified(const Image<Rgba8>& picture, const Matrix3d& matrix) {
  const Matrix3d back = matrix.inverse();
  Image<Rgba8> result(picture.width, picture.height, Rgba8{0, 0, 0, 0});
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const Vector3d from = back * Vector3d(x + 0.5, y + 0.5, 1);
      if (from.z() <= 0) continue;
      const Vector2d at = from.hnormalized();
      if (is_inside(at, picture.width, picture.height)) {
        result.at(x, y) = sample_between(picture, at);
      }
    }
  }
  return result;
}

}  // namespace glassbox::views
