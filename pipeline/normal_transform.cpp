#include <glassbox/pipeline/normal_transform.h>

#include <algorithm>

namespace glassbox::normals {
namespace {

double largest_entry(const glm::dmat3& m) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  }
  return largest;
}

// Scales by a power of two so that the largest entry is in [1/2, 1); a zero or non-finite matrix is
// unchanged.
glm::dmat3 power_of_two_scaled(const glm::dmat3& m) {
  const double largest = largest_entry(m);
  if (!(largest > 0) || !std::isfinite(largest)) return m;
  int exponent = 0;
  std::frexp(largest, &exponent);
  // `factor` * `rest` is 2^-exponent, which may be too large for one double. Nothing is rounded
  // twice: scaling up never rounds, and scaling down has rest = 1.
  constexpr int kLargestExponent = 1023;
  const double factor = std::ldexp(1.0, std::min(-exponent, kLargestExponent));
  const double rest = std::ldexp(1.0, std::max(-exponent - kLargestExponent, 0));
  glm::dmat3 scaled(0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) scaled[column][row] = m[column][row] * factor * rest;
  }
  return scaled;
}

}  // namespace

glm::dmat3 signed_cofactors(const glm::dmat3& linear) {
  const glm::dmat3 m = power_of_two_scaled(linear);
  glm::dmat3 cofactors(0);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      // The other two rows and columns in cyclic order give each cofactor its correct sign.
      const int c1 = (c + 1) % 3, c2 = (c + 2) % 3, r1 = (r + 1) % 3, r2 = (r + 2) % 3;
      cofactors[c][r] = m[c1][r1] * m[c2][r2] - m[c2][r1] * m[c1][r2];
    }
  }
  const double determinant =
      m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
  const double sign = determinant < 0 ? -1 : 1;
  glm::dmat3 result = power_of_two_scaled(cofactors);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) result[c][r] = result[c][r] * sign + 0.0;  // -0 becomes 0
  }
  return result;
}

}  // namespace glassbox::normals
