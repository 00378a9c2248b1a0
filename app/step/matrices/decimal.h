// Round numbers: the decimals that a person is likely to have typed.
#pragma once

#include <glm/vec3.hpp>

#include <string>

namespace glassbox {

// The decimal with the fewest digits within `uncertainty` of the value, and how many digits that takes; 0 takes none,
// an infinite value one. NaN takes 17.
struct Decimal {
  double value = 0;
  int digits = 0;
};
Decimal simplest_decimal(double value, double uncertainty);

// The decimal with the fewest digits within `uncertainty` of the value, as text of at most six digits.
std::string rounded(double value, double uncertainty);

// At most `digits` significant ones, without trailing zeros: "0.1", "1.5e-09", "inf".
std::string brief(double value, int digits = 6);
// "(1, 2, 3)". Coordinates whose first digit comes after the last of the largest one are shown as 0.
std::string brief_triple(const glm::dvec3& v, int digits = 6);

}  // namespace glassbox
