// Bezout's coefficients, from which generators make the smallest areas and angles that whole
// numbers allow.
#pragma once

#include <cstdint>
#include <utility>

namespace glassbox::labs {

// u x + v y is the greatest common divisor of x and y, or its negative. |u| <= |y| and |v| <= |x|,
// unless x or y is 0.
struct Bezout {
  std::int64_t u = 1, v = 0;
};

// Euclid's algorithm, which keeps each remainder as a sum u x + v y.
inline Bezout bezout(std::int64_t x, std::int64_t y) {
  Bezout result, next{0, 1};
  while (y != 0) {
    const std::int64_t quotient = x / y;
    x = std::exchange(y, x - quotient * y);
    result.u = std::exchange(next.u, result.u - quotient * next.u);
    result.v = std::exchange(next.v, result.v - quotient * next.v);
  }
  return result;
}

}  // namespace glassbox::labs
