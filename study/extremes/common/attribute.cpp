#include "study/extremes/common/attribute.h"

#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox::study {

float pipeline_attribute(const TriangleSetup& setup, const Coverage& pixel,
                         const std::array<float, 3>& values) {
  const Fragment fragment = interpolate(setup, pixel);
  return interpolate<1>({values[0]}, {values[1]}, {values[2]}, fragment.weights)[0];
}

ExactAttribute exact_attribute(const TriangleSetup& setup, const Coverage& pixel,
                               const std::array<float, 3>& values) {
  using Long = long double;
  ExactAttribute exact;
  Long sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    exact.weights[k] = Long(pixel.edges[k]) * Long(setup.inverse_w[k]);
    sum += exact.weights[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    exact.weights[k] /= sum;
    exact.value += exact.weights[k] * Long(values[k]);
  }
  return exact;
}

double attribute_bound(const ExactAttribute& exact, const std::array<float, 3>& values) {
  const double u = double(unit_roundoff<float>);
  double spread = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    spread += double(exact.weights[k]) * std::abs(double(values[k]) - double(values[0]));
  }
  return 13 * u * spread + u * std::abs(double(exact.value));
}

Outcome measure_attribute_error(const AttributeAt& at, const AttributeTriangle& judged, int side,
                                double scale) {
  const auto setup = setup_triangle(judged.triangle);
  if (!setup) return must_be_zero(HUGE_VAL, "no triangle was set up");
  std::array<float, 3> values;
  for (std::size_t k = 0; k < 3; ++k) values[k] = judged.values[std::size_t(setup->order[k])];
  WorstError worst;  // the error that is the largest fraction of its bound
  Outcome farthest;
  for_each_covered(*setup, {0, 0, side, side}, [&](const Coverage& pixel) {
    const ExactAttribute exact = exact_attribute(*setup, pixel, values);
    const double found = double(at(*setup, pixel, values));
    const double error = std::abs(found - double(exact.value)) * scale;
    const double bound = attribute_bound(exact, values) * scale;
    const std::string where = fmt::format("{:.7g} instead of {:.7g} in row {}", found * scale,
                                          double(exact.value) * scale, pixel.y);
    worst.add(error, bound, where);
    if (error > farthest.error) farthest = {error, bound, {}, where};
  });
  const Outcome outcome = worst.outcome();
  return outcome.passes() ? outcome : farthest;
}

ScreenVertex project(const View& view, const Point<Eye>& eye) {
  return to_screen(divide(round_to_float(view.clip_from_eye) * eye), view.viewport);
}

}  // namespace glassbox::study
