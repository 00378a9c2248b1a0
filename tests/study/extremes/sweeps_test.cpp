// Stiffness sweeps: errors are within their bounds, and our code is the last to fail.
#include <tests/support/catch.h>

#include <cmath>
#include <set>

#include "study/extremes/sweep.h"

namespace glassbox::study {
namespace {

TEST_CASE("every point of every sweep is within its bound, and the same in two runs",
          "[extremes]") {
  for (const Sweep& sweep : sweeps()) {
    const std::vector<SweepSeries> all = sweep.series(), again = sweep.series();
    REQUIRE(all.size() == again.size());
    int ours = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      REQUIRE(all[i].points.size() == again[i].points.size());
      ours += all[i].ours;
      for (std::size_t k = 0; k < all[i].points.size(); ++k) {
        const SweepPoint& point = all[i].points[k];
        INFO(sweep.name << ", " << all[i].name << " at " << point.parameter << ": " << point.error);
        CHECK_FALSE(std::isnan(point.error));
        CHECK(point.error == again[i].points[k].error);
        if (point.bound) CHECK(point.error <= *point.bound);
      }
    }
    INFO(sweep.name);
    CHECK(ours == 1);
  }
}

TEST_CASE("what is measured at the end of a sweep is harder than at its beginning", "[extremes]") {
  for (const Sweep& sweep : sweeps()) {
    for (const SweepSeries& series : sweep.series()) {
      INFO(sweep.name << ", " << series.name);
      for (std::size_t i = 1; i < series.points.size(); ++i) {
        // The parameter changes in one direction, up or down.
        const bool upwards = series.points[1].parameter > series.points[0].parameter;
        CHECK((series.points[i].parameter > series.points[i - 1].parameter) == upwards);
      }
      // Fractions of wrong pixels vary by chance; errors of numbers grow.
      const bool counted = sweep.error.starts_with("fraction");
      if (series.failure_parameter && !series.ours && !counted) {
        CHECK(series.points.back().error >= series.points.front().error);
      }
    }
  }
}

// Where the formats fail follows from their formulas.
TEST_CASE("float and 24 bits give up three decades of near-far ratio after 16 bits", "[extremes]") {
  const Sweep& sweep = sweeps().front();
  REQUIRE(sweep.name == "near-far");
  double at_16_bits = 0, at_float = 0;
  for (const SweepSeries& series : sweep.series()) {
    if (series.ours) CHECK_FALSE(series.failure_parameter);
    if (series.name == "16 bits") at_16_bits = series.failure_parameter.value_or(0);
    if (series.name == "float") at_float = series.failure_parameter.value_or(0);
  }
  // The ratio 2^8 is between two and three decades; the points are half a decade apart.
  CHECK(at_float / at_16_bits >= 99);
  CHECK(at_float / at_16_bits <= 1001);
}

TEST_CASE("a series gives up at its first point beyond the tolerance", "[extremes]") {
  const SweepSeries planted{"planted", false, {{1, 0.1, {}}, {2, 0.3, 0.2}, {3, 0.2, {}}}, {}};
  CHECK(with_limit(planted, 0.2).failure_parameter == 2);
  CHECK_FALSE(with_limit(planted, 0.5).failure_parameter);
  CHECK_FALSE(within_bounds(planted));
}

}  // namespace
}  // namespace glassbox::study
