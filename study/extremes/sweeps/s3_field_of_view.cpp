#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/projection.h>

#include "exact/number.h"
#include "study/extremes/sweep.h"

namespace glassbox::study {

namespace s3 {

const std::vector<double>& angles() {
  static const std::vector<double> all{1e-6,  1e-5,  1e-4,   1e-3,    1e-2,    0.1,   1,
                                       10,    45,    90,     120.0,   150,     170.0, 175,
                                       179.0, 179.9, 179.99, 179.999, 179.9999};
  return all;
}

// The axis value is 180/(180 - angle) - 1, which is small for small angles and large for angles
// near 180 degrees, so both ends have room on the axis.
double both_ends(double degrees) {
  return degrees / (180 - degrees);
}

double relative_error(double degrees, double scale) {
  const exact::Decimal half = exact::Decimal(degrees) * exact::pi() / exact::Decimal(360);
  const exact::Decimal exact = exact::Decimal(1) / exact::tan(half);
  return exact::error_of(scale, exact) / double(exact);
}

struct Method {
  const char* name;
  bool ours;
  double (*scale)(double degrees);
  double (*bound)(double degrees);
};

double condition(double degrees) {
  return fov_condition(radians_from_degrees(degrees));
}

constexpr DepthPlanes kPlanes{1, 100};

std::vector<SweepSeries> field_of_view_series() {
  const Method methods[] = {
      {"degrees, cot from sine and cosine", true,
       [](double degrees) { return perspective_degrees(degrees, 1, kPlanes)->at(1, 1); },
       [](double) { return 8 * unit_roundoff<double>; }},
      // The angle has rounding errors of up to 4 u in all (u is the unit roundoff), which the
      // condition number multiplies; tangent and quotient add up to 4 u.
      {"double, tangent of radians", false,
       [](double degrees) { return 1 / std::tan(radians_from_degrees(degrees) / 2); },
       [](double degrees) { return (4 * condition(degrees) + 4) * unit_roundoff<double>; }},
      {"float, tangent of radians", false,
       [](double degrees) {
         return double(1.0f / std::tan(float(degrees) * 0.0174532925f / 2.0f));
       },
       [](double degrees) { return (4 * condition(degrees) + 4) * double(unit_roundoff<float>); }},
  };
  std::vector<SweepSeries> all;
  for (const Method& method : methods) {
    SweepSeries series{method.name, method.ours};
    for (const double degrees : angles()) {
      const double bound = method.bound(degrees);
      series.points.push_back({both_ends(degrees), relative_error(degrees, method.scale(degrees)),
                               // The bound neglects errors of second order, so it is used only
                               // where it is small.
                               bound < 0.01 ? std::optional(bound) : std::nullopt});
    }
    all.push_back(with_limit(std::move(series), 1e-4));
  }
  return all;
}

}  // namespace s3

Sweep s3_field_of_view() {
  using namespace s3;
  return {
      .name = "field-of-view",
      .title = "Field of view",
      .question = "How narrow and how wide may a camera look before the picture's scale is wrong?",
      .axis = "angle divided by its difference from 180 degrees",
      .error = "relative error of the picture's scale, cot(angle/2)",
      .reference = "50 digits",
      .bound =
          "8 u of double (pipeline/projection.h); with radians, the rounding error of the angle "
          "times x/sin x, in float and in double",
      .tolerance = "a relative error of 1e-4, which is one pixel in ten thousand",
      .series = field_of_view_series};
}

}  // namespace glassbox::study
