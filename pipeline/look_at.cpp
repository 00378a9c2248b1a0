#include <glassbox/pipeline/look_at.h>

#include <cmath>
#include <string>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/axis_angle.h>
#include <glassbox/pipeline/number_text.h>
#include <glassbox/pipeline/unit_vector.h>

namespace glassbox {
namespace {

using WorldVector = Vector<World, double>;

// The input of both constructions of the view matrix: unit vectors that are not on one line.
struct Directions {
  WorldVector gaze, up;
};

// The coordinate axis that is most nearly perpendicular to the gaze: it can always be the up
// direction.
const char* usable_up(const WorldVector& gaze) {
  const double x = std::abs(gaze.x), y = std::abs(gaze.y), z = std::abs(gaze.z);
  if (y <= x && y <= z) return "0,1,0";
  return z <= x ? "0,0,1" : "1,0,0";
}

Result<Directions> directions_of(const Point<World, double>& eye, const WorldVector& gaze,
                                 const WorldVector& up) {
  if (!std::isfinite(eye.x) || !std::isfinite(eye.y) || !std::isfinite(eye.z)) {
    return fail("eye", triple_text(eye.x, eye.y, eye.z) + " is not a position",
                "give three finite numbers");
  }
  const auto gaze_unit = unit(gaze);
  if (!gaze_unit) {
    return fail("gaze", triple_text(gaze.x, gaze.y, gaze.z) + " is not a direction",
                "give three finite numbers that are not all zero");
  }
  const auto up_unit = unit(up);
  if (!up_unit) {
    return fail(
        "up", triple_text(up.x, up.y, up.z) + " is not a direction",
        std::string("give one that is not along the view, such as ") + usable_up(*gaze_unit));
  }
  const WorldVector across = cross(*gaze_unit, *up_unit);
  if (!(dot(across, across) >= kMinUpSine * kMinUpSine)) {
    return fail("up",
                triple_text(up.x, up.y, up.z) +
                    " points along the view, so that the picture's roll is undefined",
                std::string("choose another, such as ") + usable_up(*gaze_unit));
  }
  return Directions{*gaze_unit, *up_unit};
}

Result<WorldVector> gaze_towards(const Point<World, double>& eye,
                                 const Point<World, double>& target) {
  if (!std::isfinite(target.x) || !std::isfinite(target.y) || !std::isfinite(target.z)) {
    return fail("look-at", triple_text(target.x, target.y, target.z) + " is not a position",
                "give three finite numbers");
  }
  if (eye == target) {
    return fail("look-at",
                triple_text(target.x, target.y, target.z) +
                    " is the eye itself, so that there is no direction of view",
                "move one of the two");
  }
  return target - eye;
}

}  // namespace

Result<Transform<World, Eye>> camera_pose(const Point<World, double>& eye, const WorldVector& gaze,
                                          const WorldVector& up) {
  const Result<Directions> directions = directions_of(eye, gaze, up);
  if (!directions) return tl::unexpected(directions.error());
  const WorldVector n = -directions->gaze;
  // The cross product is not zero, because directions_of has checked the sine of the angle.
  const WorldVector u = unit(cross(directions->up, n)).value_or(WorldVector{});
  const WorldVector v = cross(n, u);
  Transform<World, Eye> pose;
  const WorldVector columns[] = {u, v, n, {eye.x, eye.y, eye.z}};
  for (int column = 0; column < 4; ++column) {
    pose.at(0, column) = columns[column].x + 0.0;  // -0 becomes 0
    pose.at(1, column) = columns[column].y + 0.0;
    pose.at(2, column) = columns[column].z + 0.0;
  }
  return pose;
}

Result<Transform<World, Eye>> camera_pose(const Point<World, double>& eye,
                                          const Point<World, double>& target,
                                          const WorldVector& up) {
  return gaze_towards(eye, target).and_then([&](const WorldVector& gaze) {
    return camera_pose(eye, gaze, up);
  });
}

Result<Transform<Eye, World>> look_at(const Point<World, double>& eye,
                                      const Point<World, double>& target, const WorldVector& up) {
  return camera_pose(eye, target, up).map([](const Transform<World, Eye>& pose) {
    return inverse_rigid(pose);
  });
}

Result<Transform<Eye, World>> look_at_axis_angle(const Point<World, double>& eye,
                                                 const Point<World, double>& target,
                                                 const WorldVector& up) {
  const Result<WorldVector> gaze = gaze_towards(eye, target);
  if (!gaze) return tl::unexpected(gaze.error());
  const Result<Directions> directions = directions_of(eye, *gaze, up);
  if (!directions) return tl::unexpected(directions.error());
  return product(axis_angle_factors(eye, directions->gaze, directions->up));
}

}  // namespace glassbox
