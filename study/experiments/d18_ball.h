// The object that the voxel experiments (D-18, D-19) reconstruct: a ball. Its pictures are computed
// pixel by pixel from the formula of the ball, and so are the distances in them.
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <glassbox/base/trig.h>

#include "views/voxels/coloring.h"
#include "views/voxels/draw_voxels.h"
#include "views/voxels/truth.h"

namespace glassbox::study::d18 {

using views::Vector3d;

inline constexpr double kRodRadius = 0.03;

struct BallPictures {
  views::PictureSet set;
  std::vector<Image<float>> distances;  // along the gaze; infinite beside the object
};

// A colour that changes by about 6 levels (of 255) over a fiftieth of the radius.
inline Rgba8 color_at(const Vector3d& p) {
  const auto level = [](double a, double b) {
    const double wave = sin_cos_degrees(170 * a).sin * sin_cos_degrees(140 * b).cos;
    return std::uint8_t(std::floor(128 + 100 * wave + 0.5));
  };
  return {level(p.x() + 0.3, p.y()), level(p.y() + 0.7, p.z()), level(p.z() + 0.1, p.x()), 255};
}

// The smallest t > 0 at which the line p + t d meets the unit ball around the origin; negative if
// there is none.
inline double hit_ball(const Vector3d& p, const Vector3d& d) {
  const double a = d.squaredNorm(), b = p.dot(d), c = p.squaredNorm() - 1;
  const double root = b * b - a * c;
  return root > 0 ? (-b - std::sqrt(root)) / a : -1;
}

// The smallest t > 0 at which the line p + t d meets one of some upright rods, which are around the
// ball and extend from half a radius below its middle to the height of its top; negative if there
// is none.
inline double hit_rods(const Vector3d& p, const Vector3d& d) {
  double nearest = -1;
  for (int i = 0; i < 6; ++i) {
    const SinCos turn = sin_cos_degrees(60.0 * i + 10);
    const double x = p.x() - 1.2 * turn.cos, z = p.z() - 1.2 * turn.sin;
    const double a = d.x() * d.x() + d.z() * d.z(), b = x * d.x() + z * d.z();
    const double root = b * b - a * (x * x + z * z - kRodRadius * kRodRadius);
    if (!(root > 0)) continue;
    const double t = (-b - std::sqrt(root)) / a, y = p.y() + t * d.y();
    if (t > 0 && y > -0.5 && y < 1 && (nearest < 0 || t < nearest)) nearest = t;
  }
  return nearest;
}

// `count` cameras on a circle 50 degrees above the ground, 6 radii away; their pictures are `side`
// px wide and show the whole box.
inline BallPictures pictures_of(int count, int side, bool has_rods) {
  BallPictures shown;
  const double reach = has_rods ? 1.25 : 1;
  shown.set.box = views::WorldBox{{-reach, -1, -reach}, {reach, 1, reach}};
  const SinCos up = sin_cos_degrees(50);
  for (int i = 0; i < count; ++i) {
    const SinCos around = sin_cos_degrees(360.0 * i / count);
    const Vector3d out(up.cos * around.sin, up.sin, up.cos * around.cos);
    views::PinholeCamera camera;
    const double focal = side * (has_rods ? 1.9 : 2.6);
    camera.intrinsic << focal, 0, side / 2.0, 0, focal, side / 2.0, 0, 0, 1;
    camera.centre = 6 * out;
    const Vector3d right = Vector3d::UnitY().cross(out).normalized();
    camera.camera_from_world.row(0) = right.transpose();
    camera.camera_from_world.row(1) = -out.cross(right).transpose();
    camera.camera_from_world.row(2) = -out.transpose();
    views::CalibratedPicture picture{"", camera, Image<Rgba8>(side, side, {0, 0, 0, 255}),
                                     Image<std::uint8_t>(side, side, 0)};
    Image<float> distance(side, side, INFINITY);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        // The ray is scaled so that t is the distance along the gaze.
        const Vector3d ray = camera.camera_from_world.transpose() *
                             views::ray_through(camera.intrinsic, {x + 0.5, y + 0.5});
        const Vector3d d = ray / ray.dot(-out);
        double t = hit_ball(camera.centre, d);
        if (has_rods) {
          const double rod = hit_rods(camera.centre, d);
          if (rod > 0 && (t < 0 || rod < t)) t = rod;
        }
        if (!(t > 0)) continue;
        picture.color.at(x, y) = color_at(camera.centre + t * d);
        picture.matte.at(x, y) = 255;
        distance.at(x, y) = float(t);
      }
    }
    shown.set.pictures.push_back(std::move(picture));
    shown.distances.push_back(std::move(distance));
  }
  return shown;
}

// A request with voxels whose edge is the ball's diameter divided by `across`.
inline views::ColoringRequest request_for(const BallPictures& shown, int across) {
  views::ColoringRequest request;
  request.box = *shown.set.box;
  request.voxel_size = 2.0 / across;
  request.settings.threads = 1;
  request.settings.threshold = 30;
  return request;
}

}  // namespace glassbox::study::d18
