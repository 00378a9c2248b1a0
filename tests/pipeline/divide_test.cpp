// The perspective divide.
#include <bit>
#include <cstdint>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/divide.h>

#include "tests/support/catch.h"

namespace {

using namespace glassbox;

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

}  // namespace

TEST_CASE("for w = 1 the divide can be left out: the bits are the same (S4-08)") {
  const std::uint64_t seed = 31;
  INFO("seed " << seed);
  Random random(seed);
  volatile float one = 1;  // a division that the compiler cannot remove
  for (int i = 0; i < 10000; ++i) {
    const float x = std::bit_cast<float>(std::uint32_t(random.bits()));
    if (x != x) continue;
    const NdcVertex ndc = divide(Point<Clip>{x, -x, x, 1});
    REQUIRE(bits(ndc.position.x) == bits(x / one));
    REQUIRE(bits(ndc.position.y) == bits(-x / one));
    REQUIRE(bits(ndc.position.z) == bits(x / one));
    REQUIRE(bits(ndc.inverse_w) == bits(1 / one));
  }
}

TEST_CASE("the quotient is the float nearest to the exact one; multiplying by 1/w often is not") {
  const std::uint64_t seed = 32;
  INFO("seed " << seed);
  Random random(seed);
  int product_differs = 0;
  for (int i = 0; i < 10000; ++i) {
    const float x = float(random.between(-4, 4)), w = float(random.between(0.5, 100));
    const NdcVertex ndc = divide(Point<Clip>{x, 0, 0, w});
    // The quotient of two floats is never so close to the middle of two floats that rounding to
    // double first would change the result (2 * 24 + 2 <= 53).
    REQUIRE(ndc.position.x == float(double(x) / double(w)));
    REQUIRE(ndc.inverse_w == float(1 / double(w)));
    product_differs += x * ndc.inverse_w != ndc.position.x;
  }
  CHECK(product_differs > 1000);
}

TEST_CASE("vertices behind the eye can be looked at before clipping") {
  const NdcVertex ndc = divide(ClipVertex{{1, 2, 3, -2}, {}});
  CHECK(ndc.position == Point<Ndc>{-0.5f, -1, -1.5f});
  CHECK(ndc.inverse_w == -0.5f);
}
