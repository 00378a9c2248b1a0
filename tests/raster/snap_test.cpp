// Snapping to 1/256 px, compared with exact rationals.
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/raster/snap.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using glassbox::Random;
using glassbox::snap;
using glassbox::test::Rational;
using BigInt = boost::multiprecision::cpp_int;

// floor(256 v + 1/2), exactly.
std::int64_t exactly_snapped(float pixels) {
  const Rational doubled = Rational(pixels) * 512 + 1;  // 2 (256 v + 1/2)
  const BigInt n = numerator(doubled);
  const BigInt d = denominator(doubled) * 2;
  BigInt q = n / d;
  if (q * d > n) --q;  // division rounds towards zero
  return std::int64_t(q);
}

// The obvious way to round, which fails (C-52).
std::int64_t carelessly_snapped(float pixels) {
  return std::int64_t(std::floor(pixels * 256.0f + 0.5f));
}

}  // namespace

TEST_CASE("exact ties k/512 snap upwards, negative ones too (C-52, C-48)") {
  for (int k = -200001; k <= 200001; k += 2) {
    const float pixels = float(k) / 512.0f;
    if (snap(pixels) == (k + 1) / 2) continue;
    CAPTURE(k, snap(pixels));
    REQUIRE(snap(pixels) == (k + 1) / 2);
  }
}

TEST_CASE(
    "a float just below a half snaps downwards, where adding a half in float would not (C-52)") {
  int careless_errors = 0;
  for (int k = -4001; k <= 4001; k += 2) {
    const float tie = float(k) / 512.0f;
    for (const float direction : {-INFINITY, INFINITY}) {
      const float pixels = std::nextafter(tie, direction);
      CAPTURE(k, pixels);
      REQUIRE(snap(pixels) == exactly_snapped(pixels));
      careless_errors += carelessly_snapped(pixels) != exactly_snapped(pixels);
    }
  }
  REQUIRE(careless_errors > 0);
}

TEST_CASE("snapping is floor(256 v + 1/2) exactly, up to 49152 px each way (C-52)") {
  const std::uint64_t seed = 52;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, int(random.integer(-30, 16)));
    const float pixels = float(std::min(49152.0, random.between(-1, 1) * size));
    CAPTURE(pixels);
    REQUIRE(snap(pixels) == exactly_snapped(pixels));
  }
  for (const float pixels : {0.0f, -0.0f, 49152.0f, -49152.0f, 32768.0f, 65535.996f}) {
    CAPTURE(pixels);
    REQUIRE(snap(pixels) == exactly_snapped(pixels));
  }
  // Floats of 2^15 px or more are multiples of 1/256, and their sum with a half is rounded to even.
  REQUIRE(carelessly_snapped(32768.00390625f) != exactly_snapped(32768.00390625f));
  REQUIRE(snap(32768.00390625f) == 8388609);
}
