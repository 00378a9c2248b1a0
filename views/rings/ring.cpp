#include "views/rings/ring.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/bounding_box.h>

namespace glassbox::views {

namespace {

constexpr int kMaxStartDegrees = 3600;

Result<void> check_options(const RingOptions& options) {
  if (options.views < 1 || options.elevations.empty() ||
      std::int64_t(options.views) * std::int64_t(options.elevations.size()) > kMaxRingViews) {
    return fail("--views", fmt::format("a ring has 1 to {} pictures", kMaxRingViews),
                "ask for a number in this range");
  }
  if (!(options.fov_degrees > 0 && options.fov_degrees < 180))
    return fail("--fov", "the angle of view must be between 0 and 180 degrees", "give 30");
  if (!(options.arc_degrees > 0 && options.arc_degrees <= 360))
    return fail("--arc", "an arc must be more than 0 and at most 360 degrees",
                "give 180 for half a ring");
  for (const double elevation : options.elevations) {
    if (std::abs(elevation) < 90) continue;
    return fail("--elevation", "an elevation must be between -90 and 90 degrees",
                "give 20, or several: 20,-20");
  }
  if (options.distance && !(*options.distance > 0 && std::isfinite(*options.distance)))
    return fail("--distance", "the distance must be positive", "leave it out");
  if (options.pair_separation &&
      !(*options.pair_separation > 0 && std::isfinite(*options.pair_separation)))
    return fail("--pairs", "the distance between the two cameras of a pair must be above 0",
                "give a positive separation");
  if (!std::isfinite(options.start_degrees) || std::abs(options.start_degrees) > kMaxStartDegrees)
    return fail(
        "--start",
        fmt::format("the first camera's angle must be at most {} degrees", kMaxStartDegrees),
        "give 0 to begin at the front");
  if (!(options.up.norm() > 0) || !std::isfinite(options.up.norm()))
    return fail("--up", "up must be a direction of finite length, not 0", "give 0,1,0");
  if (options.target && !options.target->allFinite())
    return fail("--look-at", "the target must be three numbers", "leave it out");
  return {};
}

// Two directions perpendicular to the axis and to each other. The first is the world's z axis, or y
// axis if the axis is nearly parallel to z, made perpendicular to the axis.
std::pair<Vector3d, Vector3d> perpendicular_directions(const Vector3d& axis) {
  // With y up, the ring begins at +z and goes towards +x; the automatic camera's azimuth has the
  // same origin and direction.
  Vector3d beside = Vector3d::UnitZ();
  if (std::abs(axis.z()) > 0.9) beside = Vector3d::UnitY();
  const Vector3d first = (beside - axis * axis.dot(beside)).normalized();
  return {first, axis.cross(first)};
}

// The distance from which a ball of this radius fits into the narrower angle of view, with a margin
// of 2 %.
double framing_distance(const RingOptions& options, double radius) {
  const double up = tan_half_degrees(options.fov_degrees);
  const double across = up * options.width / options.height;
  const double narrow = std::min(up, across);
  constexpr double kMargin = 1.02;
  return kMargin * radius * std::sqrt(1 + 1 / (narrow * narrow));
}

struct ClipPlanes {
  double near, far;
};

// Near and far planes that enclose a box, with a margin of 1/64. For a camera inside the box the
// near plane is at 1/1024 of the box's size.
ClipPlanes clip_planes_of(const WorldBox& box, const Vector3d& centre, const Vector3d& gaze) {
  double near = INFINITY, far = -INFINITY;
  for (const Vector3d& p : corners_of(box)) {
    const double along = gaze.dot(p - centre);
    near = std::min(near, along);
    far = std::max(far, along);
  }
  const double size = (box.high - box.low).norm(), room = size / 64, least = size / 1024;
  return {std::max(near - room, least), std::max(far + room, 2 * least)};
}

}  // namespace

WorldBox box_of(const Scene& scene) {
  const Box<World> box = bounds(scene);
  const auto &low = box.low, &high = box.high;
  return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

std::array<Vector3d, 8> corners_of(const WorldBox& box) {
  std::array<Vector3d, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1) != 0 ? box.high.x() : box.low.x(),
                  (i & 2) != 0 ? box.high.y() : box.low.y(),
                  (i & 4) != 0 ? box.high.z() : box.low.z()};
  }
  return corners;
}

Result<View> view_of(const PinholeCamera& camera, int width, int height, double near, double far) {
  const Matrix3d& k = camera.intrinsic;
  if (k(0, 1) != 0) {
    return fail("K",
                "the axes of this intrinsic matrix are skewed, but pictures are drawn with "
                "rectangular pixels",
                "use a camera without skew");
  }
  FrustumLens lens;
  lens.left = -k(0, 2) / k(0, 0) * near;
  lens.right = (width - k(0, 2)) / k(0, 0) * near;
  lens.top = k(1, 2) / k(1, 1) * near;
  lens.bottom = (k(1, 2) - height) / k(1, 1) * near;
  lens.near = near;
  lens.far = far;
  Camera made;
  made.lens = lens;
  // Eye space is the camera's space turned by half a turn about the x axis (two_view/camera.h).
  const Matrix3d axes = camera.camera_from_world.transpose() * Vector3d(1, -1, -1).asDiagonal();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      made.world_from_eye.at(row, column) = axes(row, column);
    made.world_from_eye.at(row, 3) = camera.centre[row];
  }
  return make_view(made, width, height);
}

Result<View> view_of(const PinholeCamera& camera, int width, int height, const WorldBox& box) {
  const ClipPlanes planes =
      clip_planes_of(box, camera.centre, camera.camera_from_world.row(2).transpose());
  return view_of(camera, width, height, planes.near, planes.far);
}

Result<std::vector<RingView>> ring_views(const Scene& scene, const RingOptions& options) {
  if (const auto legal = check_options(options); !legal) return tl::unexpected(legal.error());
  double radius = 0;
  const WorldBox box = box_of(scene);
  const Vector3d target = options.target.value_or((box.low + box.high) / 2);
  for_each_drawn_position(scene, [&](const Point<World, double>& p) {
    radius = std::max(radius, (Vector3d(p.x, p.y, p.z) - target).norm());
  });
  if (!(radius > 0) || !std::isfinite(radius))
    return fail(
        "the scene",
        "it has nothing visible, so there is no place that a ring of cameras could go around",
        "use another scene");
  const Vector3d axis = options.up.normalized();
  const auto [first, second] = perpendicular_directions(axis);
  const double distance = options.distance.value_or(
      framing_distance(options, radius + options.pair_separation.value_or(0) / 2));
  const double half_height = options.height / 2.0;
  PinholeCamera camera;
  const double focal = half_height / tan_half_degrees(options.fov_degrees);
  camera.intrinsic << focal, 0, options.width / 2.0, 0, focal, half_height, 0, 0, 1;
  const bool is_round = options.arc_degrees == 360;
  const double step = options.arc_degrees / std::max(1, options.views - (is_round ? 0 : 1));
  std::vector<RingView> views;
  int number = 0;
  for (const double elevation : options.elevations) {
    const SinCos up = sin_cos_degrees(elevation);
    for (int i = 0; i < options.views; ++i, ++number) {
      const SinCos around = sin_cos_degrees(options.start_degrees + step * i);
      const Vector3d out = up.sin * axis + up.cos * (around.cos * first + around.sin * second);
      const Vector3d eye = target + distance * out;
      const Vector3d right = axis.cross(out).normalized();
      camera.camera_from_world.row(0) = right.transpose();
      camera.camera_from_world.row(1) = -out.cross(right).transpose();
      camera.camera_from_world.row(2) = -out.transpose();
      const auto add = [&](double beside, const char* side) -> Result<void> {
        PinholeCamera one = camera;
        one.centre = eye + beside * right;
        const auto view = view_of(one, options.width, options.height, box);
        if (!view) return tl::unexpected(view.error());
        views.push_back({{fmt::format("view{:03}{}.png", number, side), one}, *view});
        return {};
      };
      if (!options.pair_separation) {
        if (const auto added = add(0, ""); !added) return tl::unexpected(added.error());
        continue;
      }
      const double half = *options.pair_separation / 2;
      if (const auto added = add(-half, "_left"); !added) return tl::unexpected(added.error());
      if (const auto added = add(half, "_right"); !added) return tl::unexpected(added.error());
    }
  }
  return views;
}

}  // namespace glassbox::views
