#include <glassbox/pipeline/framing.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/axis_angle.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/number_text.h>
#include <glassbox/pipeline/unit_vector.h>

namespace glassbox {
namespace {

// The limit is well below float's largest number, 2^128, so that distances around the box do not
// overflow.
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

// The box itself, or a cube around it where it is smaller than float's resolution at its place.
Box<World> with_extent(const Box<World>& bounds) {
  const Point<World, double> c = bounds.center();
  const double size = length(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y,
                             bounds.high.z - bounds.low.z);
  const double offset = length(c.x, c.y, c.z);
  if (size > std::max(offset * 0x1p-23, 0x1p-59)) return bounds;
  const double half = std::max(0.5, offset * 0x1p-20);
  return {{c.x - half, c.y - half, c.z - half}, {c.x + half, c.y + half, c.z + half}};
}

struct Interval {
  double low = 0, high = 0;
};

// The smallest and the largest distance along the gaze of the box's corners.
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

// The margin: 1 % of the range of depths; if the range is empty, 1 % of the distance; if that is 0
// too, 0.01.
double margin_of(const Interval& depths) {
  const double extent = depths.high - depths.low;
  const double distance = std::max(std::abs(depths.low), std::abs(depths.high));
  const double smallest = distance * 0x1p-20;  // a little more than float's resolution there
  if (extent > smallest) return 0.01 * extent;
  return 0.01 * (distance > 0 ? distance : 1);
}

// Reports what is wrong with the request, if anything.
Result<void> check_request(const Box<World>& bounds, double aspect, const FramingOptions& options) {
  if (const Result<void> ok = check_bounds(bounds); !ok) return ok;
  if (!(aspect > 0) || std::isinf(aspect)) {
    return fail("aspect ratio", "it is " + number_text(aspect) + ", which is not a positive number",
                "give width/height");
  }
  if (!(options.fovy_degrees > 0 && options.fovy_degrees < 180)) {
    return fail("field of view", "it is " + number_text(options.fovy_degrees) + " degrees",
                "give a full vertical angle between 0 and 180 degrees, such as 45");
  }
  const bool upright = options.elevation_degrees > -90 && options.elevation_degrees < 90;
  if (!upright || !(std::abs(options.azimuth_degrees) <= kMaxDegrees) || !(options.margin >= 1)) {
    return fail(
        "framing",
        "azimuth " + number_text(options.azimuth_degrees) + ", elevation " +
            number_text(options.elevation_degrees) + ", margin " + number_text(options.margin) +
            " do not make a view",
        "give a finite azimuth, an elevation between -90 and 90 degrees, a margin of at least 1");
  }
  return {};
}

// `v` rotated as y is rotated to the unit vector `up`: Rodrigues' formula about k = y x up, whose
// length is the sine and up.y the cosine of the angle.
Vector<World, double> turned_upright(const Vector<World, double>& v,
                                     const Vector<World, double>& up) {
  const double cosine = up.y;
  const Vector<World, double> k{up.z, 0, -up.x};
  const double sine_squared = dot(k, k);
  if (sine_squared == 0) return cosine > 0 ? v : Vector<World, double>{v.x, -v.y, -v.z};
  const double factor = rodrigues_factor(cosine, sine_squared);
  return v * cosine + cross(k, v) + k * (dot(k, v) * factor);
}

// The camera that sees every point that for_each_point(visit) visits.
template <class ForEachPoint>
Result<Camera> frame_points(const ForEachPoint& for_each_point, double aspect,
                            const FramingOptions& options) {
  const SinCos azimuth = sin_cos_degrees(options.azimuth_degrees);
  const SinCos elevation = sin_cos_degrees(options.elevation_degrees);
  const Vector<World, double> with_y_up{elevation.cos * azimuth.sin, elevation.sin,
                                        elevation.cos * azimuth.cos};
  // If `up` has no direction, +y is used here, and camera_pose below reports the error.
  const Vector<World, double> towards_eye =
      turned_upright(with_y_up, unit(options.up).value_or(Vector<World, double>{0, 1, 0}));
  const Result<Transform<World, Eye>> turned_pose =
      camera_pose(Point<World, double>{}, -towards_eye, options.up);
  if (!turned_pose) return tl::unexpected(turned_pose.error());

  // The box of the points along the axes of the eye; the axes are known before the eye's position.
  const Transform<Eye, World> turned = inverse_rigid(*turned_pose);
  Box<Eye> box;
  for_each_point([&](const Point<World, double>& p) { box.include(turned * p); });
  const Point<Eye, double> center = box.center();

  // Seen from the distance D, a point that is x to the side of the centre and z nearer to the eye
  // is within the picture if |x| <= (D - z) tan(half the angle); likewise for its height.
  const double up = tan_half_degrees(options.fovy_degrees) / options.margin;
  const double across = aspect * up;
  double distance = 0;
  for_each_point([&](const Point<World, double>& p) {
    const Vector<Eye, double> from_center = turned * p - center;
    const double needed = std::max(std::abs(from_center.x) / across, std::abs(from_center.y) / up);
    distance = std::max(distance, from_center.z + needed);
  });

  Camera camera;
  camera.name = "framing";
  camera.world_from_eye = *turned_pose;
  const Point<World, double> eye =
      *turned_pose * Point<Eye, double>{center.x, center.y, center.z + distance};
  camera.world_from_eye.at(0, 3) = eye.x;
  camera.world_from_eye.at(1, 3) = eye.y;
  camera.world_from_eye.at(2, 3) = eye.z;

  // The margin at the near and the far plane is 1 % of the distance of the nearest and farthest
  // point.
  const double half_depth = box.high.z - center.z;
  const double far = 1.01 * (distance + half_depth);
  const double near = std::max(0.99 * (distance - half_depth), far / kMaxDepthRatio);
  camera.lens = PerspectiveLens{radians_from_degrees(options.fovy_degrees), near, far};
  return camera;
}

}  // namespace

Result<Camera> framing_camera(const Box<World>& bounds, double aspect,
                              const FramingOptions& options) {
  if (const Result<void> ok = check_request(bounds, aspect, options); !ok) {
    return tl::unexpected(ok.error());
  }
  const Box<World> box = with_extent(bounds);
  const auto corners = [&](auto visit) {
    for (int i = 0; i < 8; ++i) visit(box.corner(i));
  };
  return frame_points(corners, aspect, options);
}

Result<Camera> framing_camera(const Scene& scene, double aspect, const FramingOptions& options) {
  const Box<World> box = bounds(scene);
  if (const Result<void> ok = check_request(box, aspect, options); !ok) {
    return tl::unexpected(ok.error());
  }
  if (!(with_extent(box) == box)) return framing_camera(box, aspect, options);
  return frame_points([&](auto visit) { for_each_drawn_position(scene, visit); }, aspect, options);
}

Result<NearFar> near_far_for(const Transform<World, Eye>& world_from_eye,
                             const Box<World>& bounds) {
  const Result<Interval> depths = depths_of(world_from_eye, bounds);
  if (!depths) return tl::unexpected(depths.error());
  const double margin = margin_of(*depths);
  double far = depths->high + margin;
  // If the whole box is behind the eye, `far` gets the scale of the box (near_far_for in
  // framing.h).
  if (!(depths->high > 0)) far = std::max(depths->high - depths->low, margin);
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
