#include <glassbox/base/random.h>
#include <tests/support/catch.h>

#include <cmath>
#include <vector>

#include <study/bench/statistics.h>

namespace glassbox::study {
namespace {

// Sums of some dozen logarithms, each correct to about one ulp, divided by sums of squares above 1.
constexpr double kRounding = 1e-12;

TEST_CASE("quartiles lie between the neighbours that the count asks for") {
  const Quartiles nine = quartiles({9, 1, 8, 2, 7, 3, 6, 4, 5});
  CHECK(nine.lower == 3);
  CHECK(nine.median == 5);
  CHECK(nine.upper == 7);
  // Computed with R: quantile(c(1, 2, 4, 8), c(.25, .5, .75)).
  const Quartiles four = quartiles({8, 4, 2, 1});
  CHECK(four.lower == 1.75);
  CHECK(four.median == 3);
  CHECK(four.upper == 5);
  const Quartiles one = quartiles({3});
  CHECK(one.lower == 3);
  CHECK(one.median == 3);
  CHECK(one.upper == 3);
}

TEST_CASE("one slow frame in nine moves the median by one place and no further") {
  CHECK(median({5, 5, 5, 5, 5, 6, 6, 6, 6}) == 5);
  CHECK(median({5, 5, 5, 5, 1000, 6, 6, 6, 6}) == 6);
}

std::vector<Sample> power_law(double factor, double exponent, double first, int count) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double x = first * std::pow(2, i);
    samples.push_back({x, factor * std::pow(x, exponent)});
  }
  return samples;
}

TEST_CASE("the fit finds the power law that the samples were made with") {
  for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
    const PowerLaw law = fit_power_law(power_law(3, exponent, 10, 12));
    CHECK(std::abs(law.exponent - exponent) <= kRounding);
    CHECK(std::abs(law.factor - 3) <= 100 * kRounding);
    CHECK(law.squares <= kRounding);
  }
}

TEST_CASE("samples that scatter by a factor of up to 1.1 leave the exponent within 0.02") {
  Random random(7);
  std::vector<Sample> samples = power_law(3, 1, 1000, 15);
  for (Sample& sample : samples) sample.y *= std::exp(random.between(-1, 1) * std::log(1.1));
  // Four standard deviations of the estimate: s / sqrt(sum of (x - mean)^2) = 0.0550 / sqrt(280
  // ln(2)^2) = 0.0047.
  CHECK(std::abs(fit_power_law(samples).exponent - 1) <= 0.02);
}

TEST_CASE("the bend is found where two power laws meet, and none in a straight line") {
  std::vector<Sample> bent = power_law(2, 0, 1, 7);  // constant up to x = 64
  for (const Sample& sample : power_law(2.0 / 64, 1, 128, 6)) bent.push_back(sample);
  const auto bend = find_bend(bent);
  REQUIRE(bend);
  CHECK(bend->at == 64);
  CHECK(std::abs(bend->before.exponent) <= kRounding);
  CHECK(std::abs(bend->after.exponent - 1) <= kRounding);
  CHECK_FALSE(find_bend(power_law(2, 1, 1, 12)));
  CHECK_FALSE(find_bend(power_law(2, 1, 1, 4)));
}

}  // namespace
}  // namespace glassbox::study
