#include <glassbox/pipeline/framing.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {
namespace {

// Half of what float holds is left for the distances around the box.
constexpr double kLargestCoordinate = 0x1p100;

Result<void> check_bounds(const Box<World>& bounds) {
  if (bounds.empty()) {
    return fail("scene bounds", "there is nothing to look at",
                "give a scene with at least one vertex");
  }
  for (const Point<World, double>& p : {bounds.low, bounds.high}) {
    for (double coordinate : {p.x, p.y, p.z}) {
      if (std::abs(coordinate) <= kLargestCoordinate) continue;
      return fail("scene bounds", "a coordinate reaches " + number_text(coordinate),
                  "scale the scene down");
    }
  }
  return {};
}

double length(double x, double y, double z) {
  return std::sqrt(x * x + y * y + z * z);
}

// Radius of the sphere to frame. A box smaller than float's resolution at its place is a point.
double framed_radius(const Box<World>& bounds) {
  const Point<World, double> c = bounds.center();
  const double radius = 0.5 * length(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y,
                                     bounds.high.z - bounds.low.z);
  const double offset = length(c.x, c.y, c.z);
  const double smallest = std::max(offset * 0x1p-24, 0x1p-60);
  return radius > smallest ? radius : std::max(0.5, offset * 0x1p-20);
}

struct Interval {
  double low = 0, high = 0;
};

// How far along the gaze the box's corners lie.
Result<Interval> depths_of(const Transform<World, Eye>& world_from_eye, const Box<World>& bounds) {
  if (const Result<void> ok = check_bounds(bounds); !ok) return tl::unexpected(ok.error());
  const Transform<Eye, World> eye_from_world = inverse_rigid(world_from_eye);
  Interval depths{Box<World>::kInfinity, -Box<World>::kInfinity};
  for (int i = 0; i < 8; ++i) {
    const double depth = -(eye_from_world * bounds.corner(i)).z;
    if (!std::isfinite(depth)) {
      return fail("camera pose", "it is not finite", "give finite numbers");
    }
    depths.low = std::min(depths.low, depth);
    depths.high = std::max(depths.high, depth);
  }
  return depths;
}

// 1 % of the box's depth; of its distance where it has none; of 1 at the eye itself.
double margin_of(const Interval& depths) {
  const double extent = depths.high - depths.low;
  const double distance = std::max(std::abs(depths.low), std::abs(depths.high));
  const double smallest = distance * 0x1p-20;  // what float can tell apart there, and some
  if (extent > smallest) return 0.01 * extent;
  return 0.01 * (distance > 0 ? distance : 1);
}

}  // namespace

Result<Camera> frame(const Box<World>& bounds, double aspect, const FramingOptions& options) {
  if (const Result<void> ok = check_bounds(bounds); !ok) return tl::unexpected(ok.error());
  if (!(aspect > 0) || std::isinf(aspect)) {
    return fail("aspect ratio", "it is " + number_text(aspect) + ", which is not a positive number",
                "give width/height");
  }
  if (!(options.fovy_degrees > 0 && options.fovy_degrees < 180)) {
    return fail("field of view", "it is " + number_text(options.fovy_degrees) + " degrees",
                "give a full vertical angle between 0 and 180 degrees, such as 45");
  }
  const SinCos azimuth = sin_cos_degrees(options.azimuth_degrees);
  const SinCos elevation = sin_cos_degrees(options.elevation_degrees);
  if (!(elevation.cos > 0) || std::isnan(azimuth.sin) || !(options.margin >= 1)) {
    return fail(
        "framing",
        "azimuth " + number_text(options.azimuth_degrees) + ", elevation " +
            number_text(options.elevation_degrees) + ", margin " + number_text(options.margin) +
            " do not make a view",
        "give a finite azimuth, an elevation between -90 and 90 degrees, a margin of at least 1");
  }

  // A sphere of radius r at distance D touches the planes of a half-angle h where sin h = r/D; the narrower of the two
  // directions decides.
  const double radius = framed_radius(bounds) * options.margin;
  const SinCos vertical = sin_cos_degrees(options.fovy_degrees * 0.5);
  const double across =
      aspect * (vertical.sin / vertical.cos);  // tangent of the horizontal half-angle
  const double horizontal_sin = across / std::sqrt(1 + across * across);
  const double distance = radius / std::min(vertical.sin, horizontal_sin);

  const Point<World, double> center = bounds.center();
  const Vector<World, double> towards_eye{elevation.cos * azimuth.sin, elevation.sin,
                                          elevation.cos * azimuth.cos};
  const Result<Transform<World, Eye>> pose =
      camera_pose(center + towards_eye * distance, -towards_eye, Vector<World, double>{0, 1, 0});
  if (!pose) return tl::unexpected(pose.error());

  const double far = distance + radius;
  const double near = std::max(distance - radius, far / kMaxDepthRatio);
  Camera camera;
  camera.name = "framing";
  camera.lens = PerspectiveLens{radians_from_degrees(options.fovy_degrees), near, far};
  camera.world_from_eye = *pose;
  return camera;
}

Result<NearFar> near_far_for(const Transform<World, Eye>& world_from_eye,
                             const Box<World>& bounds) {
  const Result<Interval> depths = depths_of(world_from_eye, bounds);
  if (!depths) return tl::unexpected(depths.error());
  const double margin = margin_of(*depths);
  double far = depths->high + margin;
  if (!(depths->high > 0))
    far = std::max(depths->high - depths->low, margin);  // all of it behind the eye
  return NearFar{std::max(depths->low - margin, far / kMaxDepthRatio), far};
}

Result<NearFar> parallel_near_far_for(const Transform<World, Eye>& world_from_eye,
                                      const Box<World>& bounds) {
  const Result<Interval> depths = depths_of(world_from_eye, bounds);
  if (!depths) return tl::unexpected(depths.error());
  const double margin = margin_of(*depths);
  return NearFar{depths->low - margin, depths->high + margin};
}

}  // namespace glassbox
