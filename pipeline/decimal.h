// Round numbers: the decimals that a person is likely to have typed.
#pragma once

#include <string>

namespace glassbox {

// The decimal with the fewest digits within `uncertainty` of the value, and how many digits that takes; 0 takes none,
// an infinite value one. NaN takes 17.
struct Decimal {
  double value = 0;
  int digits = 0;
};
Decimal simplest_decimal(double value, double uncertainty);

// At most `digits` significant ones, without trailing zeros: "0.1", "1.5e-09", "inf".
std::string brief(double value, int digits = 6);
std::string brief_triple(double x, double y, double z, int digits = 6);  // "(1, 2, 3)"

}  // namespace glassbox
