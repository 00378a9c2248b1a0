// Random pairs of cameras and the points that they see.
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "views/two_view/estimate.h"
#include "views/two_view/match.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views::test {

// The camera matrix of a picture of 640 x 480 pixels, with the numbers published for normalized
// points (B.8).
inline Matrix3d sample_intrinsic() {
  Matrix3d k;
  k << 800, 0, 320, 0, 800, 240, 0, 0, 1;
  return k;
}

inline double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector3d{normal(random), normal(random), normal(random)}.normalized();
}

// A pair of cameras: the right one is turned by up to `angle` radians and is 0.3 to 1 away in any
// direction.
inline StereoRig random_rig(std::mt19937& random, double angle = 0.3) {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = sample_intrinsic();
  const double turn = uniform(random, -angle, angle);
  rig.pose.rotation = Eigen::AngleAxisd(turn, random_direction(random)).matrix();
  const double length = uniform(random, 0.3, 1);
  rig.pose.translation = length * random_direction(random);
  return rig;
}

inline Match projected_match(const Vector3d& point, const StereoRig& rig) {
  const Vector3d left = rig.left_intrinsic * point;
  const Vector3d right = rig.right_intrinsic * rig.pose.rotation * (point - rig.pose.translation);
  return {left.hnormalized(), right.hnormalized()};
}

// A point in front of both cameras, `nearest` to `farthest` away, inside the left picture.
inline Vector3d random_point(std::mt19937& random, const StereoRig& rig, double nearest = 2,
                             double farthest = 10) {
  for (;;) {
    const Vector2d pixel{uniform(random, 0, 640), uniform(random, 0, 480)};
    const Vector3d point =
        uniform(random, nearest, farthest) * ray_through(rig.left_intrinsic, pixel);
    if ((rig.pose.rotation * (point - rig.pose.translation)).z() > 1) return point;
  }
}

inline Vector2d noise(std::mt19937& random, double sigma) {
  std::normal_distribution<double> normal(0, sigma);
  const double x = normal(random), y = normal(random);
  return sigma > 0 ? Vector2d(x, y) : Vector2d::Zero();
}

inline Matches random_matches(std::mt19937& random, const StereoRig& rig, int count,
                              double sigma = 0, double nearest = 2, double farthest = 10) {
  Matches matches;
  for (int i = 0; i < count; ++i) {
    Match match = projected_match(random_point(random, rig, nearest, farthest), rig);
    match.left += noise(random, sigma);
    match.right += noise(random, sigma);
    matches.push_back(match);
  }
  return matches;
}

inline Matches calibrated(const Matches& pixels, const StereoRig& rig) {
  return views::calibrated(pixels, rig.left_intrinsic, rig.right_intrinsic);
}

// The distance of two matrices up to sign and scale.
inline double matrix_distance(const Matrix3d& a, const Matrix3d& b) {
  const Matrix3d p = a.normalized(), q = b.normalized();
  return std::min((p - q).norm(), (p + q).norm());
}

}  // namespace glassbox::views::test
