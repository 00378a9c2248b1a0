// What a match says about the place of the point that it shows, in the world: its two rays, the
// point by one of the methods, and how far both can be trusted (S2-05, S2-13).
#pragma once

#include <array>
#include <optional>

#include "views/two_view/error_ellipsoid.h"

namespace glassbox::views {

// A half line: from the camera's centre through the pixel. The direction has length 1.
struct WorldRay {
  Vector3d origin, direction;
};

enum class PointState {
  kInFront,         // of both cameras
  kBehindLeft,      // behind the left camera, or beside it: its depth there is not positive
  kBehindRight,     // the same for the right camera
  kBehindBoth,      // the same for both cameras
  kNearlyParallel,  // the rays' angle is below three of its standard deviations
  kAtInfinity,      // the rays are parallel: only a direction is known
  kOnBaseline,      // a ray goes through both centres, so the place along it is not known
  kOutOfRange,      // a number overflows
};
inline constexpr PointState kPointStates[] = {PointState::kInFront,        PointState::kBehindLeft,
                                              PointState::kBehindRight,    PointState::kBehindBoth,
                                              PointState::kNearlyParallel, PointState::kAtInfinity,
                                              PointState::kOnBaseline,     PointState::kOutOfRange};
// The state in words: "behind the left camera".
const char* name_of(PointState state);

// Two numbers or vectors belong to the left and the right camera. Positions are in world units.
struct LocatedPoint {
  std::array<WorldRay, 2> rays;
  double angle = 0;        // between the rays, radians
  double angle_sigma = 0;  // its standard deviation, to first order, radians
  // Where the rays are closest: the distances t_l and t_r along the rays, negative behind a camera,
  // and the gap there. Absent for parallel rays.
  std::optional<ClosestPoints> closest;
  PointState state = PointState::kOutOfRange;
  // Homogeneous: (X, Y, Z, 1), or a direction and 0 at infinity.
  Vector4d point = Vector4d::Zero();
  std::array<bool, 2> in_front{};
  // The distances between the point's pixels and those of the match, px; infinite if the point is
  // beside a camera.
  std::array<double, 2> reprojection_errors{};
  // Absent if there is no finite point or a camera has it beside itself.
  std::optional<ErrorEllipsoid> ellipsoid;

  bool has_place() const { return point.w() != 0 && state < PointState::kAtInfinity; }
  // The square root of the sum of both squared reprojection errors, px.
  double residual() const;
};

// `sigma` is the standard deviation of each coordinate of both pixels, px. The rays are parallel if
// they are so to within rounding (see midpoint()), and go through both centres if they do so to
// within 64 units of rounding.
LocatedPoint locate(Triangulator how, const Match& pixels,
                    const std::array<PinholeCamera, 2>& cameras, double sigma);

// Whether both cameras have the same centre, to within the rounding of the centres' coordinates:
// each is computed as -R^T t, three products of numbers of that size, so 32 units of rounding are
// allowed.
bool are_in_one_place(const std::array<PinholeCamera, 2>& cameras);

}  // namespace glassbox::views
