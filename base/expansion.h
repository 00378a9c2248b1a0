// Exact sums and products of doubles, for the few decisions that rounding must not influence.
//
// A number is stored as an expansion: a sum of doubles, smallest first, no two of which share a bit
// (Dekker 1971, Knuth 1997 4.2.2, Shewchuk 1997). Its sign is the sign of its last term. Capacities
// are part of the type, so nothing is allocated; only + - * of IEEE doubles are used, rounded to
// nearest, without fused multiply-add.
//
// Valid inputs are zero or have 2^-200 <= |x| <= 2^200. Every float qualifies (2^-149 .. 2^128).
// Products of up to four such numbers neither overflow nor lose a bit to underflow: the last bit of
// a factor is at least 2^-252, so that of a product is at least 2^(4 * -252) = 2^-1008, and
// splitting a factor costs another 2^27.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace glassbox {

// Whether the exact operations accept x as a factor.
inline bool is_exactly_computable(double x) {
  const double magnitude = std::abs(x);
  return x == 0 || (magnitude >= 0x1p-200 && magnitude <= 0x1p200);  // false for NaN
}

// `high` is the rounded result of an operation, and high + low is its exact result.
struct TwoTerms {
  double high;
  double low;
};

inline TwoTerms two_sum(double a, double b) {
  const double sum = a + b;
  const double b_in_sum = sum - a;
  const double a_in_sum = sum - b_in_sum;
  return {sum, (a - a_in_sum) + (b - b_in_sum)};
}

inline TwoTerms two_difference(double a, double b) {
  return two_sum(a, -b);
}

// Splits a double into two parts of at most 26 bits each (Veltkamp), so that products of parts are
// exact.
inline TwoTerms split(double a) {
  const double shifted = 0x8000001p0 * a;  // the factor is 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

inline TwoTerms two_product(double a, double b) {
  const double product = a * b;
  const TwoTerms x = split(a);
  const TwoTerms y = split(b);
  const double missing = ((product - x.high * y.high) - x.low * y.high) - x.high * y.low;
  return {product, x.low * y.low - missing};
}

// A number of at most `Capacity` terms; zero terms are left out, so zero has none.
template <int Capacity>
struct Expansion {
  std::array<double, std::size_t(Capacity)> terms;
  int count = 0;

  Expansion() {}  // leaves the unused terms uninitialised: some expansions are long
  explicit Expansion(double value) { append(value); }
  explicit Expansion(const TwoTerms& value) {
    append(value.low);
    append(value.high);
  }

  // Appends the next larger term of a number that is built up from its smallest term.
  void append(double term) {
    if (term != 0) terms[std::size_t(count++)] = term;
  }

  // Adds one double (Shewchuk's Grow-Expansion). The caller must make sure that there is room: the
  // capacity must be one more than the terms in use, or as large as the number of bits that the
  // result can span.
  void add(double value) {
    const int old_count = count;
    count = 0;
    for (int i = 0; i < old_count; ++i) {
      const TwoTerms sum = two_sum(value, terms[std::size_t(i)]);
      append(sum.low);  // written behind the term that is being read: nothing is overwritten
      value = sum.high;
    }
    append(value);
  }

  template <int N>
  void add(const Expansion<N>& other) {
    for (int i = 0; i < other.count; ++i) add(other.terms[std::size_t(i)]);
  }

  int sign() const {
    if (count == 0) return 0;
    return terms[std::size_t(count - 1)] > 0 ? 1 : -1;
  }

  // The number as a double, to a few units in the last place. The sign is right because the largest
  // terms are added first: a partial sum is exact until it is 2^53 times larger than all the
  // remaining terms.
  double estimate() const {
    double sum = 0;
    for (int i = count - 1; i >= 0; --i) sum += terms[std::size_t(i)];
    return sum;
  }
};

template <int N>
Expansion<N> operator-(const Expansion<N>& a) {
  Expansion<N> negated = a;
  for (int i = 0; i < a.count; ++i) negated.terms[std::size_t(i)] = -a.terms[std::size_t(i)];
  return negated;
}

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> sum;
  for (int i = 0; i < a.count; ++i) sum.append(a.terms[std::size_t(i)]);
  sum.add(b);
  return sum;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

template <int N>
Expansion<2 * N> operator*(const Expansion<N>& a, double factor) {
  Expansion<2 * N> scaled;
  for (int i = 0; i < a.count; ++i) {
    const TwoTerms product = two_product(a.terms[std::size_t(i)], factor);
    scaled.add(product.low);
    scaled.add(product.high);
  }
  return scaled;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> product;
  for (int i = 0; i < b.count; ++i) product.add(a * b.terms[std::size_t(i)]);
  return product;
}

inline Expansion<2> exact_difference(double a, double b) {
  return Expansion<2>(two_difference(a, b));
}
inline Expansion<2> exact_product(double a, double b) {
  return Expansion<2>(two_product(a, b));
}

using Exact2 = std::array<double, 2>;
using Exact3 = std::array<double, 3>;

// The sign of (a - c) x (b - c): +1 if the turn a, b, c is counter-clockwise, -1 if clockwise, 0 if
// the points are on one line. Exact for valid inputs. Nearly always the double result is larger
// than its error bound (Shewchuk 1997), and exact arithmetic is not needed.
int sign_of_orient2d(const Exact2& a, const Exact2& b, const Exact2& c);

// The sign of the determinant with the rows a - d, b - d, c - d: +1 if a, b, c turn clockwise as
// seen from d, 0 if the four points are in one plane. Exact for valid inputs; like
// sign_of_orient2d, it tries doubles first.
int sign_of_orient3d(const Exact3& a, const Exact3& b, const Exact3& c, const Exact3& d);

// a[0] b[0] + ... + a[n-1] b[n-1] for at most kMaxProducts pairs. The sign of the result is exact
// (0 only where the sum is 0), and its size is right to a few units in the last place of the
// largest product.
inline constexpr int kMaxProducts = 8;
double sum_of_products(std::span<const double> a, std::span<const double> b);

}  // namespace glassbox
