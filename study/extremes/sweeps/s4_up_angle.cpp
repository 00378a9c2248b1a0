#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/look_at.h>

#include "exact/camera.h"
#include "study/extremes/sweep.h"
#include "study/naive/camera.h"

namespace glassbox::study {

namespace s4 {

using LooksAt = Result<Transform<Eye, World>> (*)(const Point<World, double>&,
                                                  const Point<World, double>&,
                                                  const Vector<World, double>&);

const Point<World, double> kEye(1, 2, 3), kTarget(4, -1, 5);

// An up vector at this angle to the gaze, in the plane of the gaze and a vector perpendicular to
// it.
Vector<World, double> up_at(double angle) {
  const Vector<World, double> gaze = kTarget - kEye;
  const Vector<World, double> across = cross(gaze, Vector<World, double>(0, 1, 0));
  const double same_length = std::sqrt(dot(gaze, gaze) / dot(across, across));
  return gaze * std::cos(angle) + across * (same_length * std::sin(angle));
}

double angle_between_u(const Transform<Eye, World>& found,
                       const exact::Matrix4<exact::Decimal>& exact) {
  const exact::DecimalVector u(exact.at[0][0], exact.at[0][1], exact.at[0][2]);
  return exact::angle(
      exact::exactly(Vector<World, double>(found.at(0, 0), found.at(0, 1), found.at(0, 2))), u);
}

SweepSeries series_of(const char* name, bool ours, LooksAt looks_at, double roundoff) {
  SweepSeries series{name, ours};
  for (int quarter = 0; quarter <= 32; ++quarter) {
    const double angle = std::pow(10.0, -quarter / 4.0);
    const auto found = looks_at(kEye, kTarget, up_at(angle));
    const bool sound = found && std::isfinite(found->at(0, 0));
    const double error = sound
                             ? angle_between_u(*found, exact::look_at(kEye, kTarget, up_at(angle)))
                             : std::numeric_limits<double>::infinity();
    // The bound is (8 + 4/sine) u for each of three entries (pipeline/look_at.h; u is the unit
    // roundoff); there is none if the method has no answer.
    const double bound = std::sqrt(3.0) * (8 + 4 / std::sin(angle)) * roundoff;
    series.points.push_back(
        {angle, error, sound && bound < 0.1 ? std::optional(bound) : std::nullopt});
  }
  return with_limit(std::move(series), 1e-3);
}

std::vector<SweepSeries> up_angle_series() {
  return {series_of("look_at, in double", true, look_at, unit_roundoff<double>),
          series_of("look_at in double, without its limit", false, naive::look_at_without_limit,
                    unit_roundoff<double>),
          series_of("float", false, naive::look_at_in_float, double(unit_roundoff<float>))};
}

}  // namespace s4

Sweep s4_up_angle() {
  using namespace s4;
  return {
      .name = "up-angle",
      .title = "Angle between up and gaze",
      .question = "How small may the angle between `up` and the gaze be before the camera rolls?",
      .axis = "angle between up and gaze",
      .axis_unit = "radians",
      .error = "roll: angle between the computed and the true right-hand axis",
      .error_unit = "radians",
      .reference = "UVN in 50 digits",
      .bound = "sqrt 3 (8 + 4/sin) u (pipeline/look_at.h, B.5)",
      .tolerance =
          "an error of the roll of a thousandth of a radian, which is a pixel in a thousand, or a "
          "refusal; look_at refuses sines below 2^-20",
      .series = up_angle_series};
}

}  // namespace glassbox::study
