// Compares the distance of two floats with counting the floats between them one by one.
#include "tests/support/catch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <glassbox/base/random.h>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox::test {
namespace {

using Limits = std::numeric_limits<float>;
constexpr float kInfinity = Limits::infinity();

std::uint32_t distance(float a, float b) {
  return ulp_distance(a, b, false);
}

// Returns the float after `value`, where -0 and +0 count as two floats; std::nextafter takes them
// for one.
float next(float value) {
  if (value == 0 && std::signbit(value)) return 0.0f;
  const float after = std::nextafter(value, kInfinity);
  return after == 0 ? -0.0f : after;
}

// Returns `count` consecutive floats that begin with `first`.
std::vector<float> line_from(float first, int count) {
  std::vector<float> line{first};
  while (int(line.size()) < count) line.push_back(next(line.back()));
  return line;
}

void check_all_pairs(const std::vector<float>& line) {
  REQUIRE(line.size() > 2);
  for (std::size_t i = 0; i < line.size(); ++i) {
    for (std::size_t j = 0; j < line.size(); ++j) {
      const auto steps = std::uint32_t(i < j ? j - i : i - j);
      if (distance(line[i], line[j]) == steps) continue;
      INFO(line[i] << " and " << line[j] << " are " << steps << " floats apart");
      CHECK(distance(line[i], line[j]) == steps);
      return;
    }
  }
}

TEST_CASE("around zero every pair of floats is as far apart as counting says") {
  // The list has 250 denormals, -0, +0 and 250 denormals.
  const auto line = line_from(-250 * Limits::denorm_min(), 502);
  REQUIRE(line[250] == 0);
  REQUIRE(std::signbit(line[250]));
  REQUIRE(line[251] == 0);
  REQUIRE(!std::signbit(line[251]));
  check_all_pairs(line);
  CHECK(distance(-0.0f, 0.0f) == 1);
  CHECK(distance(-0.0f, -0.0f) == 0);
}

TEST_CASE("where the spacing of floats changes, counting goes on") {
  for (int exponent = -149; exponent <= 127; ++exponent) {
    for (const float sign : {-1.0f, 1.0f}) {
      float first = sign * std::ldexp(1.0f, exponent);
      for (int back = 0; back < 8; ++back) {
        const float before = std::nextafter(first, -kInfinity);
        first = before == 0 ? -0.0f : before;
      }
      INFO("powers of two: " << exponent);
      check_all_pairs(line_from(first, 17));
    }
  }
  // The smallest normal number and the largest denormal.
  CHECK(distance(Limits::min(), std::nextafter(Limits::min(), 0.0f)) == 1);
  CHECK(distance(0.0f, Limits::min()) == 0x00800000u);
}

TEST_CASE("the two ends of the line are a finite distance apart") {
  CHECK(distance(0.0f, Limits::max()) == 0x7f7fffffu);
  CHECK(distance(-Limits::max(), Limits::max()) == 0xfeffffffu);
  CHECK(distance(-Limits::max(), Limits::max()) < kUnbounded);
}

TEST_CASE("an infinity is no finite distance from anything but itself") {
  CHECK(distance(kInfinity, kInfinity) == 0);
  CHECK(distance(-kInfinity, -kInfinity) == 0);
  CHECK(distance(-kInfinity, kInfinity) == kUnbounded);
  for (const float finite : {0.0f, -0.0f, 1.0f, Limits::max(), -Limits::max()}) {
    for (const float infinity : {kInfinity, -kInfinity}) {
      CHECK(distance(finite, infinity) == kUnbounded);
      CHECK(distance(infinity, finite) == kUnbounded);
    }
  }
}

TEST_CASE("NaN differs from everything, and from NaN unless asked otherwise") {
  std::vector<float> nans;
  for (const std::uint32_t bits : {0x7fc00000u, 0xffc00000u, 0x7f800001u, 0xffffffffu}) {
    nans.push_back(std::bit_cast<float>(bits));
  }
  for (const float nan : nans) {
    for (const float other : nans) {
      CHECK(ulp_distance(nan, other, false) == kUnbounded);
      CHECK(ulp_distance(nan, other, true) == 0);
    }
    for (const float number : {0.0f, 1.0f, -1.0f, kInfinity, -kInfinity}) {
      for (const bool nan_equals_nan : {false, true}) {
        CHECK(ulp_distance(nan, number, nan_equals_nan) == kUnbounded);
        CHECK(ulp_distance(number, nan, nan_equals_nan) == kUnbounded);
      }
    }
  }
}

float random_finite(Random& random) {
  for (;;) {
    const float value = std::bit_cast<float>(std::uint32_t(random.bits()));
    if (std::isfinite(value)) return value;
  }
}

TEST_CASE("the distance of random neighbours is the number of steps between them") {
  Random random(1);
  int right = 0;
  for (int round = 0; round < 2000; ++round) {
    const float start = random_finite(random);
    const auto steps = std::uint32_t(random.integer(0, 300));
    float end = start;
    for (std::uint32_t i = 0; i < steps; ++i) end = next(end);
    if (std::isinf(end)) continue;
    if (distance(start, end) == steps && distance(end, start) == steps) {
      ++right;
      continue;
    }
    INFO("seed 1, round " << round << ": " << start << " and " << end);
    CHECK(distance(start, end) == steps);
    CHECK(distance(end, start) == steps);
  }
  CHECK(right > 1900);  // all but the few that reach infinity
}

TEST_CASE("distances are symmetric, and add up along the line") {
  Random random(2);
  const auto place = [](float a, float b) {
    return a < b || (a == b && std::signbit(a) && !std::signbit(b));
  };
  int right = 0;
  for (int round = 0; round < 20000; ++round) {
    float three[] = {random_finite(random), random_finite(random), random_finite(random)};
    if (round % 7 == 0) three[1] = round % 2 == 0 ? 0.0f : -0.0f;
    std::sort(three, three + 3, place);
    const auto& [low, middle, high] = three;
    const std::uint32_t whole = distance(low, high);
    const bool adds_up =
        whole == distance(low, middle) + distance(middle, high) && whole == distance(high, low);
    right += adds_up ? 1 : 0;
    if (adds_up) continue;
    INFO("seed 2, round " << round << ": " << low << ", " << middle << ", " << high);
    CHECK(adds_up);
  }
  CHECK(right == 20000);
}

}  // namespace
}  // namespace glassbox::test
