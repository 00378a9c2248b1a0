#include <glassbox/base/expansion.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

constexpr double kRoundoff = unit_roundoff<double>;

int sign_of(double x) {
  return (x > 0) - (x < 0);
}

using Difference = Expansion<2>;

Expansion<16> exact_determinant(const Difference& a, const Difference& b, const Difference& c,
                                const Difference& d) {
  return a * d - b * c;
}

int exact_orient2d(const Exact2& a, const Exact2& b, const Exact2& c) {
  return exact_determinant(exact_difference(a[0], c[0]), exact_difference(a[1], c[1]),
                           exact_difference(b[0], c[0]), exact_difference(b[1], c[1]))
      .sign();
}

int exact_orient3d(const Exact3& a, const Exact3& b, const Exact3& c, const Exact3& d) {
  std::array<Difference, 3> p, q, r;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = exact_difference(a[i], d[i]);
    q[i] = exact_difference(b[i], d[i]);
    r[i] = exact_difference(c[i], d[i]);
  }
  return (exact_determinant(p[0], p[1], q[0], q[1]) * r[2] +
          exact_determinant(q[0], q[1], r[0], r[1]) * p[2] +
          exact_determinant(r[0], r[1], p[0], p[1]) * q[2])
      .sign();
}

}  // namespace

int sign_of_orient2d(const Exact2& a, const Exact2& b, const Exact2& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  const double determinant = left - right;
  constexpr double kBound = (3 + 16 * kRoundoff) * kRoundoff;
  if (std::abs(determinant) > kBound * (std::abs(left) + std::abs(right))) {
    return sign_of(determinant);
  }
  return exact_orient2d(a, b, c);
}

int sign_of_orient3d(const Exact3& a, const Exact3& b, const Exact3& c, const Exact3& d) {
  const Exact3 p{a[0] - d[0], a[1] - d[1], a[2] - d[2]};
  const Exact3 q{b[0] - d[0], b[1] - d[1], b[2] - d[2]};
  const Exact3 r{c[0] - d[0], c[1] - d[1], c[2] - d[2]};
  const double determinant = p[2] * (q[0] * r[1] - r[0] * q[1]) +
                             q[2] * (r[0] * p[1] - p[0] * r[1]) +
                             r[2] * (p[0] * q[1] - q[0] * p[1]);
  const double permanent = std::abs(p[2]) * (std::abs(q[0] * r[1]) + std::abs(r[0] * q[1])) +
                           std::abs(q[2]) * (std::abs(r[0] * p[1]) + std::abs(p[0] * r[1])) +
                           std::abs(r[2]) * (std::abs(p[0] * q[1]) + std::abs(q[0] * p[1]));
  constexpr double kBound = (7 + 56 * kRoundoff) * kRoundoff;
  if (std::abs(determinant) > kBound * permanent) return sign_of(determinant);
  return exact_orient3d(a, b, c, d);
}

double sum_of_products(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  double magnitude = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double product = a[i] * b[i];
    sum += product;
    magnitude += std::abs(product);
  }
  // A product is rounded once, and then at most n - 1 times in the sum, for n products: an error of
  // at most n u times the magnitude, where u is the unit roundoff. The magnitude has rounding
  // errors, too; one more u covers them, which are terms of second order.
  const double bound = double(a.size() + 1) * kRoundoff * magnitude;
  if (std::abs(sum) > bound) return sum;
  Expansion<2 * kMaxProducts> exact;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const TwoTerms product = two_product(a[i], b[i]);
    exact.add(product.low);
    exact.add(product.high);
  }
  return exact.estimate();
}

}  // namespace glassbox
