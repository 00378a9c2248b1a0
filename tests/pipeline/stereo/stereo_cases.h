// Random cameras, pairs of eyes and points that they see, in double.
#pragma once

#include <glassbox/base/random.h>
#include <tests/support/catch.h>

#include <cmath>
#include <limits>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline View view_of(const Lens& lens, int width = 1280, int height = 720,
                    DepthRange range = DepthRange::kStandard,
                    const Transform<World, Eye>& pose = {}) {
  Camera camera;
  camera.lens = lens;
  camera.world_from_eye = pose;
  const Result<View> view = make_view(camera, width, height, range);
  REQUIRE(view);
  return *view;
}

inline Transform<World, Eye> random_pose(Random& random) {
  const auto number = [&] { return random.between(-10, 10); };
  Result<Transform<World, Eye>> pose = tl::unexpected(Error{});
  while (!pose) {
    const Point<World, double> eye{number(), number(), number()};
    const Vector<World, double> gaze{number(), number(), number()};
    pose = camera_pose(eye, gaze, {0, 1, 0});
  }
  return *pose;
}

// A perspective view: centred or off-axis, with a finite or infinite far plane, in either depth
// range.
inline View random_perspective(Random& random, const Transform<World, Eye>& pose = {}) {
  const DepthRange range =
      random.integer(0, 1) == 0 ? DepthRange::kStandard : DepthRange::kReversed;
  const double near = std::exp(random.between(-5, 1));
  const std::optional<double> far =
      random.integer(0, 2) == 0 ? std::optional<double>{} : near * std::exp(random.between(2, 10));
  const int width = int(random.integer(64, 4096)), height = int(random.integer(64, 4096));
  if (random.integer(0, 1) == 0) {
    const double fovy = radians_from_degrees(random.between(10, 110));
    return view_of(PerspectiveLens{fovy, near, far}, width, height, range, pose);
  }
  const double half = near * random.between(0.2, 1.5), x = half * random.between(-1, 1),
               y = half * random.between(-1, 1);
  return view_of(FrustumLens{x - half, x + half, y - half, y + half, near, far}, width, height,
                 range, pose);
}

inline View random_parallel(Random& random, const Transform<World, Eye>& pose = {}) {
  const double near = random.between(-1, 1);
  const OrthographicLens lens{random.between(1, 20), near, near + random.between(5, 50)};
  const int width = int(random.integer(64, 4096)), height = int(random.integer(64, 4096));
  return view_of(lens, width, height,
                 random.integer(0, 1) == 0 ? DepthRange::kStandard : DepthRange::kReversed, pose);
}

inline View random_view(Random& random, const Transform<World, Eye>& pose = {}) {
  return random.integer(0, 3) == 0 ? random_parallel(random, pose)
                                   : random_perspective(random, pose);
}

// A random distance between the near plane (for a parallel camera at least just in front of it) and
// the far plane; for a perspective camera its inverse is evenly distributed.
inline double random_distance(Random& random, const View& view) {
  if (!view.perspective) return random.between(std::max(view.near, 0.01), view.far);
  const double inverse = random.between(1 / view.far, 1 / view.near);
  return std::min(1 / inverse, 1e6 * view.near);
}

// A pair whose separation is at most a tenth of check_pair's limit, which is three times a usual
// one.
inline StereoPair random_pair(Random& random, const View& view) {
  const double window = random_distance(random, view);
  return {random.between(0.0001, 0.1) * window_half_width(view, window), window};
}

// A point at this distance that the centre camera sees.
inline Point<Eye, double> random_seen(Random& random, const View& view, double distance) {
  const auto& m = view.clip_from_eye;
  const double w = view.perspective ? distance : 1;
  const auto coordinate = [&](int axis) {
    return (random.between(-1, 1) * w + m.at(axis, 2) * distance - m.at(axis, 3)) /
           m.at(axis, axis);
  };
  const double x = coordinate(0), y = coordinate(1);
  return {x, y, -distance};
}

inline Point<Screen, double> screen_of(const View& view, const Point<World, double>& p) {
  const Point<Clip, double> c = view.clip_from_eye * (view.eye_from_world * p);
  const Viewport& v = view.viewport;
  return {(c.x / c.w + 1) / 2 * double(v.width()) + double(v.left),
          (1 - c.y / c.w) / 2 * double(v.height()) + double(v.top), c.z / c.w};
}

// The world position of a point, for views whose pose is the identity.
inline Point<World, double> world_of(const Point<Eye, double>& p) {
  return {p.x, p.y, p.z};
}

}  // namespace glassbox::test
