// Round numbers: the decimal numbers that a person probably typed.
#pragma once

#include <glm/vec3.hpp>

#include <string>

namespace glassbox {

// The decimal number with the fewest digits within `uncertainty` of the value, and its number of
// digits. 0 has no digits, an infinite value one, NaN 17.
struct Decimal {
  double value = 0;
  int digits = 0;
};
Decimal simplest_decimal(double value, double uncertainty);

// The simplest decimal within `uncertainty` of the value, as text with at most six digits.
std::string rounded_text(double value, double uncertainty);

// The value with at most `digits` significant digits, without trailing zeros: "0.1", "1.5e-09",
// "inf".
std::string short_number(double value, int digits = 6);
// Three coordinates as "(1, 2, 3)". A coordinate that is too small to be visible in the digits of
// the largest one is shown as 0.
std::string short_vector_text(const glm::dvec3& v, int digits = 6);

}  // namespace glassbox
