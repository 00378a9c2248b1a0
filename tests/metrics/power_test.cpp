// Compares the elementary functions of FLIP with those of the C library in double precision.
#include <glassbox/images/colour/power.h>

#include <cmath>

#include <glassbox/base/random.h>
#include "tests/support/catch.h"

namespace {

using namespace glassbox;

constexpr std::uint64_t kSeed = 20200701;

// Calls check for every 251st float from `low` to `high`, and for both ends.
template <class Check>
void for_floats(float low, float high, const Check& check) {
  const auto end = std::bit_cast<std::uint32_t>(high);
  for (auto bits = std::bit_cast<std::uint32_t>(low); bits < end; bits += 251) {
    check(std::bit_cast<float>(bits));
  }
  check(high);
}

}  // namespace

TEST_CASE("cube roots are within 2^-23 of the true ones", "[metrics]") {
  double worst = 0;
  for_floats(0x1p-80f, 0x1p100f, [&](float value) {
    const double truth = std::cbrt(double(value));
    worst = std::max(worst, std::abs(double(cube_root(value)) - truth) / truth);
  });
  CHECK(worst < 0x1p-23);
}

TEST_CASE("base-2 logarithms and powers of 2 keep their bounds", "[metrics]") {
  double worst_log = 0;
  for_floats(0x1p-126f, 0x1p127f, [&](float value) {
    const double truth = std::log2(double(value));
    const double error = std::abs(double(log_2(value)) - truth);
    worst_log = std::max(worst_log, error / std::max(1.0, std::abs(truth)));
  });
  CHECK(worst_log < 0x1p-23);

  double worst_power = 0;
  Random random(kSeed);
  for (int i = 0; i < 1000000; ++i) {
    const float value = float(random.between(-126, 127));
    const double truth = std::exp2(double(value));
    worst_power = std::max(worst_power, std::abs(double(exp_2(value)) - truth) / truth);
  }
  CHECK(worst_power < 0x1p-22);
}

TEST_CASE("powers keep their bound, and 0 stays 0", "[metrics]") {
  Random random(kSeed);
  for (int i = 0; i < 1000000; ++i) {
    const float base = float(random.between(0, i % 2 == 0 ? 1 : 400));
    const float exponent = float(random.unit());
    const double truth = std::pow(double(base), double(exponent));
    const double error = std::abs(double(power(base, exponent)) - truth) / truth;
    if (error >= 0x1p-21 + 0x1p-23 * std::abs(std::log2(truth))) {
      INFO("seed " << kSeed << ": " << base << " to the power of " << exponent << " is " << truth
                   << ", not " << power(base, exponent));
      FAIL_CHECK();
    }
  }
  CHECK(power(0.0f, 0.7f) == 0.0f);
  CHECK(power(0.0f, 0.0f) == 1.0f);
  CHECK(power(1.0f, 0.3f) == 1.0f);
}
