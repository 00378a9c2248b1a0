// Numbers with an error bound: the third set of types for which the formulas of the stages are
// compiled, besides single numbers (base/numbers.h) and the vectors of numbers in raster/lanes.
// `value` is the number that the program computes, bit by bit; `bound` is an upper bound of its
// distance from the result of exact arithmetic on the same input (running error analysis: Wilkinson
// 1986; Higham, section 3.3).
//
// Where x and y approximate exact values X and Y, |x - X| <= dx and |y - Y| <= dy, and r is the
// rounding error of the operation:
//
//   x + y    dx + dy + r                       x y     |x| dy + |y| dx + dx dy + r
//   x / y    (dx + |x/y| dy)/(|y| - dy) + r    sqrt x  dx/(sqrt x + sqrt(x - dx)) + r, or sqrt dx
//                                                      where dx > x
//
// r is not estimated as u (the unit roundoff) times the result, but is what this operation really
// rounds. For floats it is computed, because sums and products of floats fit doubles; for doubles
// it is 2^-53 of the result. Where nothing is rounded, r is 0: 1 times x has the bound of x. A
// comparison also says whether its result is certain; select() with an uncertain condition returns
// a bound that covers both numbers. The bounds are doubles, each rounded up by a factor 1 + 2^-49,
// which covers the at most eight roundings of its own computation; a bound is infinite where
// nothing can be said.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include <glassbox/base/numbers.h>

namespace glassbox::bounded {

inline constexpr double kRoundUp = 1 + 0x1p-49;

// The result of comparing two computed numbers, and whether comparing the exact numbers would
// certainly give the same result.
struct UncertainBool {
  bool holds = false;
  bool is_sure = true;

  friend UncertainBool operator!(UncertainBool a) { return {!a.holds, a.is_sure}; }
  // If one operand is certainly true, the result is certain, whatever the other operand is.
  friend UncertainBool operator||(UncertainBool a, UncertainBool b) {
    return {a.holds || b.holds,
            (a.holds && a.is_sure) || (b.holds && b.is_sure) || (a.is_sure && b.is_sure)};
  }
};

template <class T>
struct BoundedOf;
template <class T>
BoundedOf<T> sum_of(const BoundedOf<T>& x, const BoundedOf<T>& y);
template <class T>
BoundedOf<T> product_of(const BoundedOf<T>& x, const BoundedOf<T>& y);
template <class T>
BoundedOf<T> quotient_of(const BoundedOf<T>& x, const BoundedOf<T>& y);

template <class T>
struct BoundedOf {
  T value = 0;
  double bound = 0;

  BoundedOf() = default;
  BoundedOf(T exact) : value(exact) {}
  // Where the bound is NaN or the value is not finite, the bound becomes infinite.
  BoundedOf(T computed, double bound_)
      : value(computed),
        bound(std::isfinite(computed) && bound_ >= 0 ? bound_
                                                     : std::numeric_limits<double>::infinity()) {}

  bool is_bounded() const { return std::isfinite(bound); }

  // Friends, so that an exact number can be on either side: 1 / x.
  friend BoundedOf operator+(const BoundedOf& x, const BoundedOf& y) { return sum_of(x, y); }
  friend BoundedOf operator-(const BoundedOf& x, const BoundedOf& y) { return sum_of(x, -y); }
  friend BoundedOf operator*(const BoundedOf& x, const BoundedOf& y) { return product_of(x, y); }
  friend BoundedOf operator/(const BoundedOf& x, const BoundedOf& y) { return quotient_of(x, y); }
  friend BoundedOf operator-(const BoundedOf& x) { return {-x.value, x.bound}; }
  BoundedOf& operator+=(const BoundedOf& y) { return *this = *this + y; }

  friend UncertainBool operator<(const BoundedOf& x, const BoundedOf& y) {
    return {x.value < y.value, is_certain(x, y)};
  }
  friend UncertainBool operator>(const BoundedOf& x, const BoundedOf& y) { return y < x; }
  friend UncertainBool operator<=(const BoundedOf& x, const BoundedOf& y) {
    return {x.value <= y.value, is_certain(x, y)};
  }
  friend UncertainBool operator!=(const BoundedOf& x, const BoundedOf& y) {
    return {x.value != y.value, is_certain(x, y)};
  }

private:
  // Whether the result of a comparison is certain. Two numbers without error compare as their exact
  // values do, also if they are equal.
  static bool is_certain(const BoundedOf& x, const BoundedOf& y) {
    if (x.bound == 0 && y.bound == 0) return true;
    return std::abs(double(x.value) - double(y.value)) > (x.bound + y.bound) * kRoundUp;
  }
};
using Bounded = BoundedOf<float>;

template <class F>
concept Number = std::same_as<F, BoundedOf<float>> || std::same_as<F, BoundedOf<double>>;

// a b, where 0 times infinity is 0: an infinite bound does no harm if it is multiplied by 0.
inline double times(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

// ---- how much an operation rounds ----

// An upper bound of the distance between `rounded` and the exact result, which is within `off` of
// `near`.
template <class T>
double rounding_error(T rounded, double near, double off) {
  return std::abs(near - double(rounded)) + off;
}

// The rounding error of a sum of doubles, exactly (Knuth's TwoSum).
inline double sum_rounding_error(double a, double b, double sum) {
  const double b_there = sum - a, a_there = sum - b_there;
  return std::abs((a - a_there) + (b - b_there));
}

inline constexpr double kHalfUlp = 0x1p-53;

// Whether a = b c without rounding. Only known for floats.
template <class T>
bool is_product(T a, T b, T c) {
  return std::same_as<T, float> && double(b) * double(c) == double(a);
}

template <class T>
BoundedOf<T> abs(const BoundedOf<T>& x) {
  return {std::abs(x.value), x.bound};
}

template <class T>
BoundedOf<T> sum_of(const BoundedOf<T>& x, const BoundedOf<T>& y) {
  const T value = x.value + y.value;
  const double a = double(x.value), b = double(y.value), near = a + b;
  const double own = rounding_error(value, near, sum_rounding_error(a, b, near));
  return {value, (x.bound + y.bound + own) * kRoundUp};
}
template <class T>
BoundedOf<T> product_of(const BoundedOf<T>& x, const BoundedOf<T>& y) {
  const T value = x.value * y.value;
  const double a = std::abs(double(x.value)), b = std::abs(double(y.value));
  // The product of two floats is exact in double.
  const double near = double(x.value) * double(y.value);
  // The product of doubles may be subnormal and then have a larger relative error, so kSmallest is
  // added. If a factor is 0, nothing is rounded.
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  const double own = std::same_as<T, float> ? rounding_error(value, near, 0)
                     : a == 0 || b == 0     ? 0
                                            : std::abs(near) * kHalfUlp + kSmallest;
  return {value,
          (times(a, y.bound) + times(b, x.bound) + times(x.bound, y.bound) + own) * kRoundUp};
}
template <class T>
BoundedOf<T> quotient_of(const BoundedOf<T>& x, const BoundedOf<T>& y) {
  const T value = x.value / y.value;
  const double smallest = std::abs(double(y.value)) - y.bound;
  if (!(smallest > 0)) return {value, std::numeric_limits<double>::infinity()};
  const double near = double(x.value) / double(y.value), size = std::abs(near);
  const bool is_exact = x.value == 0 || is_product(x.value, value, y.value);
  const double own = is_exact ? 0 : rounding_error(value, near, size * kHalfUlp + 0x1p-1074);
  return {value, ((x.bound + times(size, y.bound)) / smallest + own) * kRoundUp};
}

// The square root. Neither x nor the exact value that it approximates may be negative.
template <class T>
BoundedOf<T> sqrt(const BoundedOf<T>& x) {
  const T value = std::sqrt(x.value);
  const double size = double(x.value), near = std::sqrt(size);
  const double own =
      is_product(x.value, value, value) ? 0 : rounding_error(value, near, near * kHalfUlp);
  if (x.bound == 0) return {value, own * kRoundUp};
  const double inherited = x.bound <= size
                               ? x.bound / (near + std::sqrt(size - x.bound) * (1 - 0x1p-50))
                               : std::sqrt(x.bound);
  return {value, (inherited + own) * kRoundUp};
}

// ---- conditions ----

template <Number F>
F select(UncertainBool condition, F yes, F no) {
  F chosen = condition.holds ? yes : no;
  if (condition.is_sure) return chosen;
  const F other = condition.holds ? no : yes;
  const double apart = std::abs(double(chosen.value) - double(other.value));
  const double whole = (apart + other.bound) * kRoundUp;
  // If the bound of `chosen` is NaN, the comparison is false and gives `whole`.
  return {chosen.value, whole <= chosen.bound ? chosen.bound : whole};
}
template <Number F>
F select(bool condition, F yes, F no) {
  return condition ? yes : no;
}

// Whether the condition is certainly false: the exact numbers do not fulfil it either.
inline bool none(UncertainBool condition) {
  return !condition.holds && condition.is_sure;
}

// ---- kinds of numbers ----

inline BoundedOf<double> widened(const Bounded& x) {
  return {double(x.value), x.bound};
}
inline Bounded rounded(const BoundedOf<double>& x) {
  const float value = float(x.value);
  return {value, (x.bound + rounding_error(value, x.value, 0)) * kRoundUp};
}

// A whole number as the nearest float; |i| <= 2^62.
inline Bounded to_float(std::int64_t i) {
  const float value = float(i);
  return {value, std::abs(double(std::int64_t(value) - i))};
}

// `value` with the bound of `same`, the result of another formula that is equal in exact
// arithmetic. The distance between the two is added.
inline Bounded with_bound_from(float value, const Bounded& same) {
  return {value, (same.bound + std::abs(double(value) - double(same.value))) * kRoundUp};
}

#include <glassbox/base/formulas/common.h>

}  // namespace glassbox::bounded
