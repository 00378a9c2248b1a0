// Random pairs of cameras and random matches, the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <glassbox/base/random.h>

#include "views/two_view/estimate.h"
#include "views/two_view/match.h"
#include "views/two_view/triangulation.h"

namespace glassbox::study {

// The intrinsic matrix of a camera with 640 x 480 pixels and a focal length of 800 px (B.8).
inline views::Matrix3d sample_intrinsic() {
  views::Matrix3d k;
  k << 800, 0, 320, 0, 800, 240, 0, 0, 1;
  return k;
}

// The rotation that belongs to the quaternion (1, x, y, z) after normalising.
inline views::Matrix3d turned_by(double x, double y, double z) {
  return Eigen::Quaterniond(1, x, y, z).normalized().toRotationMatrix();
}

// Two cameras with the intrinsic matrix sample_intrinsic(); the right one is at `centre` and turned
// by `rotation`.
inline views::StereoRig rig_at(const views::Vector3d& centre,
                               const views::Matrix3d& rotation = views::Matrix3d::Identity()) {
  views::StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = sample_intrinsic();
  rig.pose = {rotation, centre};
  return rig;
}

// A random point in the unit ball, but not near its centre.
inline views::Vector3d random_ball_point(Random& random) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    const views::Vector3d v(x, y, random.between(-1, 1));
    if (v.norm() <= 1 && v.norm() >= 0.3) return v;
  }
}

// A rig whose right camera is 0.3 to 1 unit away from the left one in any direction and turned by
// up to half a radian.
inline views::StereoRig random_rig(Random& random) {
  const views::Vector3d centre = random_ball_point(random), axis = random_ball_point(random) / 8;
  return rig_at(centre, turned_by(axis.x(), axis.y(), axis.z()));
}

// A nearly normal random number, as the sum of twelve uniform ones; only the tails differ from
// those of a normal distribution.
inline double gaussian(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

inline views::Vector2d pixel_noise(Random& random, double sigma) {
  const double x = gaussian(random);
  return sigma * views::Vector2d(x, gaussian(random));
}

inline views::Match project_match(const views::StereoRig& rig, const views::Vector3d& point) {
  const views::Vector3d left = rig.left_intrinsic * point;
  const views::Vector3d right =
      rig.right_intrinsic * rig.pose.rotation * (point - rig.pose.translation);
  return {left.hnormalized(), right.hnormalized()};
}

inline views::Match project_match(const views::StereoRig& rig, const views::Vector3d& point,
                                  double sigma, Random& random) {
  views::Match match = project_match(rig, point);
  match.left += pixel_noise(random, sigma);
  match.right += pixel_noise(random, sigma);
  return match;
}

// A random point that the left picture shows, between two distances along the left camera's gaze,
// and in front of the right camera.
inline views::Vector3d random_visible_point(Random& random, const views::StereoRig& rig,
                                            double nearest, double farthest) {
  for (;;) {
    const double x = random.between(0, 640), y = random.between(0, 480);
    const views::Vector3d point =
        random.between(nearest, farthest) * views::ray_through(rig.left_intrinsic, {x, y});
    if ((rig.pose.rotation * (point - rig.pose.translation)).z() > 1) return point;
  }
}

inline views::Matches matches_of(Random& random, const views::StereoRig& rig, int count,
                                 double sigma, double nearest = 2, double farthest = 10) {
  views::Matches matches;
  while (int(matches.size()) < count)
    matches.push_back(
        project_match(rig, random_visible_point(random, rig, nearest, farthest), sigma, random));
  return matches;
}

// Like matches_of, but the points are on a plane about six units away, which leans by up to half a
// radian.
inline views::Matches matches_of_plane(Random& random, const views::StereoRig& rig, int count,
                                       double sigma) {
  const double lean = random.between(-0.5, 0.5);
  const views::Vector3d normal = views::Vector3d(lean, random.between(-0.5, 0.5), -1).normalized();
  views::Matches matches;
  while (int(matches.size()) < count) {
    const views::Vector3d ray = random_visible_point(random, rig, 2, 10);
    matches.push_back(project_match(rig, ray * (-6 / ray.dot(normal)), sigma, random));
  }
  return matches;
}

// The matches as points on the image planes at distance 1.
inline views::Matches calibrated(const views::Matches& pixels, const views::StereoRig& rig) {
  return views::calibrated(pixels, rig.left_intrinsic, rig.right_intrinsic);
}

// The distance of two matrices after scaling both to norm 1, where a difference in sign does not
// count.
inline double matrix_distance(const views::Matrix3d& a, const views::Matrix3d& b) {
  const views::Matrix3d p = a.normalized(), q = b.normalized();
  return std::min((p - q).norm(), (p + q).norm());
}

}  // namespace glassbox::study
