// The experiments on layered depth images, D-14 to D-17.
#include <cmath>
#include <numbers>
#include <string>

#include "study/experiments/d14_model.h"
#include "study/experiments/d17_leaves.h"
#include "tests/study/experiments/check_experiment.h"

using namespace glassbox;
using namespace glassbox::study;
using namespace glassbox::test;

namespace {

// The error of a single configuration.
double error_of(const Experiment& experiment, const std::string& series, double parameter,
                const std::string& measure = "") {
  for (const Configuration& c : experiment.configurations(Effort::kQuick)) {
    if (c.series == series && c.parameter == parameter && c.measure == measure) return c.error();
  }
  FAIL("there is no " << series << " at " << parameter);
  return 0;
}

}  // namespace

// n additions to a sum of size W err by n ulp(W): the square of the width, apart from where W is
// within its power of two.
TEST_CASE("D-14: sums that are not begun anew drift with the square of the width, ours do not") {
  const Experiment experiment = d14_layer_warp();
  const auto growth = [&](const char* series) {
    return std::log(error_of(experiment, series, 8192) / error_of(experiment, series, 300)) /
           std::log(8192.0 / 300);
  };
  CHECK(std::abs(growth("float, added up, restarted each row") - 2) < 0.25);
  CHECK(std::abs(growth("float, multiples of the step, restarted every 64 px") - 1) < 0.25);
}

TEST_CASE("D-14: a coordinate comes to another pixel with the probability E min(1, |error|)") {
  // The integral of P(|e| > t) over t from 0 to 1 by the midpoint rule, whose error is h^2/24 of
  // the largest second derivative, 0.5 / deviation^2.
  constexpr int kSteps = 1000;
  for (const double deviation : {0.2, 0.7, 1.0, 5.0}) {
    double share = 0;
    for (int i = 0; i < kSteps; ++i)
      share += std::erfc((i + 0.5) / kSteps / deviation / std::numbers::sqrt2) / kSteps;
    CHECK(std::abs(d14::share_moved(deviation) - share) < 0.5 / square(deviation * kSteps) / 24);
  }
  CHECK(d14::share_moved(0) == 0);
  CHECK(d14::share_moved(1e6) <= 1);
}

TEST_CASE("D-15: facing, 1 - 1/m^2 of a wall are holes with a pixel a sample, none with sides l") {
  int judged = 0;
  for (const Configuration& c : d15_splats().configurations(Effort::kQuick)) {
    if (c.scene != "wall" || !c.measure.empty()) continue;
    INFO(c.series << " at " << c.parameter);
    const double m = std::max(c.parameter, 1.0);
    if (c.series == "1 x 1") CHECK(c.error() == 1 - 1 / (m * m));
    if (c.series == "square of side l") CHECK(c.error() == 0);
    ++judged;
  }
  CHECK(judged == 4 * 6);
}

TEST_CASE("D-16: the order of visits shows what depth shows, unless things are seen smaller") {
  for (const Configuration& c : d16_layer_order().configurations(Effort::kQuick)) {
    INFO(c.series << ", " << c.scene << " at " << c.parameter);
    const bool by_depth = c.series == "the nearest sample, by depth";
    const bool in_order = c.series == "the last sample, in McMillan's order for this eye";
    const bool is_exact = by_depth || (in_order && c.scene != "back, a thin slab");
    CHECK((c.error() == 0) == is_exact);
  }
}

TEST_CASE(
    "D-17: each layer halves at least what another eye lacks among leaves, a second eye too") {
  const auto all = check_experiment(d17_layers());
  for (const char* series : {"one eye's layers", "two eyes' layers"}) {
    for (const double layers : {1.0, 2.0, 3.0}) {
      INFO(series << " at " << layers);
      CHECK(error_at(all, series, "leaves", layers + 1) <=
            error_at(all, series, "leaves", layers) / 2);
    }
  }
  for (const double layers : {1.0, 2.0, 3.0, 4.0}) {
    CHECK(error_at(all, "two eyes' layers", "leaves", layers) <
          0.6 * error_at(all, "one eye's layers", "leaves", layers));
  }
}

TEST_CASE("D-17: of an endless slab of leaves k layers lack 2^-k") {
  for (int k = 1; k <= 6; ++k) {
    CHECK(d17::missing_share(40, k, 1) == Approx(std::ldexp(1.0, -k)).epsilon(1e-3));
    CHECK(d17::kept_layers(40, k) == Approx(k).epsilon(1e-9));
  }
  CHECK(d17::missing_share(40, 1, 2) == Approx(1.0 / 3).epsilon(1e-3));
  CHECK(d17::merged_share(3, 1e-6) == Approx(1.5e-6).epsilon(1e-3));
}
