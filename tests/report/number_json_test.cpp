// Numbers of a report that JSON cannot represent.
#include "cli/report/number_json.h"

#include <limits>

#include "tests/support/catch.h"

namespace glassbox::test {

TEST_CASE("numbers that JSON cannot write are null, or the word for an infinite one") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  CHECK(finite_json(1.5).dump() == "1.5");
  for (const double value : {kInfinity, -kInfinity, kNan}) CHECK(finite_json(value).is_null());
  CHECK(finite_or_inf(1.5).dump() == "1.5");
  CHECK(finite_or_inf(kInfinity) == "inf");
  CHECK(finite_or_inf(-kInfinity) == "-inf");
  CHECK(finite_or_inf(kNan).is_null());
}

}  // namespace glassbox::test
