// Measures how far a matrix is from a rotation (D-13).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "study/experiments/d13_methods.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {

// Returns a . b - minus, an entry of R R^T - I for a matrix R, with twice the digits of double:
// every product is split into its rounded value and its rounding error (fma).
inline double exact_dot(const std::array<double, 3>& a, const std::array<double, 3>& b,
                        double minus) {
  double sum = -minus, rest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double product = a[k] * b[k];
    rest += std::fma(a[k], b[k], -product);
    const double next = sum + product;
    // Knuth's sum finds the exact rounding error of the addition.
    const double shown = next - sum;
    rest += (sum - (next - shown)) + (product - shown);
    sum = next;
  }
  return sum + rest;
}

template <class T>
RotationMatrix<double> defect(const RotationMatrix<T>& r) {
  RotationMatrix<double> d, e;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) d[i][j] = double(r[i][j]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) e[i][j] = exact_dot(d[i], d[j], i == j ? 1 : 0);
  }
  return e;
}

inline double frobenius(const RotationMatrix<double>& m) {
  double sum = 0;
  for (const auto& row : m) {
    for (const double x : row) sum += square(x);
  }
  return std::sqrt(sum);
}

}  // namespace glassbox::study
