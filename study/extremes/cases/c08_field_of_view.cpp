#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/projection.h>

#include "exact/number.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c08 {

// Computes the scale of the picture, the matrix entry [1][1]; returns nothing for an angle that is
// rejected.
using Scale = std::optional<double> (*)(double fovy_degrees);

Outcome measure_error(Scale scale) {
  WorstError worst;
  for (const double degrees : {1e-6, 1e-3, 1.0, 45.0, 90.0, 179.0, 179.99, 179.9999}) {
    const auto value = scale(degrees);
    const exact::Decimal half =
        exact::Decimal(degrees) * exact::pi() / exact::Decimal(std::int64_t(360));
    const exact::Decimal exact = exact::Decimal(1) / exact::tan(half);
    // The bound is 4 ulps, each at most 2 u of the value (projection.h; u is the unit roundoff).
    worst.add(value ? exact::error_of(*value, exact) / double(exact) : HUGE_VAL,
              8 * unit_roundoff<double>, fmt::format("{} degrees", degrees),
              fov_condition(radians_from_degrees(degrees)));
  }
  int accepted = 0;
  for (const double degrees : {0.0, -45.0, 180.0, 180.0001, 360.0}) {
    accepted += scale(degrees).has_value();
  }
  if (accepted > 0) worst.add(HUGE_VAL, 0, "an impossible angle was accepted");
  return worst.outcome(fmt::format("{} of 5 impossible angles were accepted", accepted));
}

std::optional<double> ours(double degrees) {
  const auto m = perspective_degrees(degrees, 1, {1, 100});
  if (!m) return std::nullopt;
  return m->at(1, 1);
}
std::optional<double> tangent_in_float(double degrees) {
  return 1 / std::tan(float(degrees) * 3.14159265f / 360);
}
// Checks the angle and computes in double, but converts to radians: near 180 degrees, the rounding
// error of the conversion is multiplied by x/sin x, where x is the angle.
std::optional<double> by_radians(double degrees) {
  if (!ours(degrees)) return std::nullopt;
  return 1 / std::tan(radians_from_degrees(degrees) / 2);
}

// The same picture for a narrow and for a wide angle of view: the triangles are scaled to the
// angle.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    for (const double degrees : {1e-3, 1.0, 90.0, 179.0, 179.99}) {
      const double radians = radians_from_degrees(degrees);
      const float t = float(std::tan(radians / 2));
      all.emplace_back(make_ray_scene({{Point<Eye>{-0.7f * t, -0.6f * t, -1},
                                        {1.6f * t, -0.4f * t, -2},
                                        {0.2f * t, 2.4f * t, -3}}},
                                      PerspectiveLens{radians, 0.5, 8.0}, 64));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c08

ExtremeCase c08_field_of_view() {
  using namespace c08;
  return {
      .id = "C-08",
      .name = "Fields of view near 0 and 180 degrees",
      .construction =
          "fields of view of 1e-6 .. 179.9999 degrees; then impossible ones: 0, negative, 180 and "
          "more",
      .stage = "projection",
      .right_answer =
          "the scale is cot(x/2) to 4 ulps (pipeline/projection.h); angles outside of (0, 180) are "
          "refused",
      .unit = "of the scale",
      .oracle = Oracle::kExtended,
      .ours = {"perspective_degrees", [] { return measure_error(ours); }},
      .naive = {"1 / tan in float, without any check",
                [] { return measure_error(tangent_in_float); }},
      .mutants = {{"the angle is converted to radians first",
                   [] { return measure_error(by_radians); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
