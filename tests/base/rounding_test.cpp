#include <tests/support/catch.h>

#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

TEST_CASE("unit roundoff is half the gap above 1") {
  CHECK(unit_roundoff<float> == 0x1p-24f);
  CHECK(unit_roundoff<double> == 0x1p-53);
  CHECK(gamma<float>(0) == 0);
  CHECK(gamma<float>(4) == 0x1p-22 / (1 - 0x1p-22));
}

TEST_CASE("an ulp is the gap to the next larger magnitude") {
  CHECK(ulp(1.0) == 0x1p-52);
  CHECK(ulp(-1.5f) == 0x1p-23f);
  CHECK(ulp(0.0f) == std::numeric_limits<float>::denorm_min());
  CHECK(ulp(std::numeric_limits<float>::max()) == 0x1p104f);
  CHECK(std::isnan(ulp(std::numeric_limits<double>::infinity())));
}

TEST_CASE("the distance in ulps counts the numbers between, across 0 too") {
  CHECK(ulp_distance(1.0, 1.0) == 0);
  CHECK(ulp_distance(-0.0, 0.0) == 0);
  CHECK(ulp_distance(1.0f, std::nextafter(1.0f, 2.0f)) == 1);
  CHECK(ulp_distance(-std::numeric_limits<double>::denorm_min(),
                     std::numeric_limits<double>::denorm_min()) == 2);
  CHECK(ulp_distance(std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity()) ==
        1);
  CHECK(ulp_distance(std::nan(""), 1.0) == std::numeric_limits<std::uint64_t>::max());
}

}  // namespace
}  // namespace glassbox
