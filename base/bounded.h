// Numbers that know how far they may be off: a third reading of the stages' formulas, beside that of single numbers
// (base/numbers.h) and that of lanes. A number is the one that the run computes, bit by bit, and beside it a bound of its
// distance from what exact arithmetic makes of the same input (running error analysis: Wilkinson 1986; Higham, section 3.3).
//
// Where x and y stand for exact values X and Y, |x - X| <= dx and |y - Y| <= dy, and r is what the operation rounds:
//
//   x + y    dx + dy + r                       x y     |x| dy + |y| dx + dx dy + r
//   x / y    (dx + |x/y| dy)/(|y| - dy) + r    sqrt x  dx/(sqrt x + sqrt(x - dx)) + r, or sqrt dx where dx > x
//
// r is not u times the result but what this operation has rounded: of floats it is computed, as sums and products of floats fit
// doubles; of doubles it is 2^-53 of the result. Where nothing is rounded nothing is charged, so 1 times x is as good as x.
// A comparison knows whether it is sure. select() of one that is not has to stand for either of its numbers. The bounds are
// doubles, each rounded up by 2^-49, which covers the eight roundings of its own at most; infinite where nothing can be said.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include <glassbox/base/numbers.h>

namespace glassbox::bounded {

inline constexpr double kRoundUp = 1 + 0x1p-49;

// What a comparison says of the numbers, and whether it says the same of the exact ones.
struct Truth {
  bool holds = false;
  bool is_sure = true;

  friend Truth operator!(Truth a) { return {!a.holds, a.is_sure}; }
  // What is certain of one of the two decides, whatever the other is.
  friend Truth operator||(Truth a, Truth b) {
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
  // A bound that is no number, and a number that is none, are without bound.
  BoundedOf(T computed, double bound_)
      : value(computed),
        bound(std::isfinite(computed) && bound_ >= 0 ? bound_
                                                     : std::numeric_limits<double>::infinity()) {}

  bool is_bounded() const { return std::isfinite(bound); }

  // Friends, so that a number without a bound may stand on either side: 1 / x.
  friend BoundedOf operator+(const BoundedOf& x, const BoundedOf& y) { return sum_of(x, y); }
  friend BoundedOf operator-(const BoundedOf& x, const BoundedOf& y) { return sum_of(x, -y); }
  friend BoundedOf operator*(const BoundedOf& x, const BoundedOf& y) { return product_of(x, y); }
  friend BoundedOf operator/(const BoundedOf& x, const BoundedOf& y) { return quotient_of(x, y); }
  friend BoundedOf operator-(const BoundedOf& x) { return {-x.value, x.bound}; }
  BoundedOf& operator+=(const BoundedOf& y) { return *this = *this + y; }

  friend Truth operator<(const BoundedOf& x, const BoundedOf& y) {
    return {x.value < y.value, are_apart(x, y)};
  }
  friend Truth operator>(const BoundedOf& x, const BoundedOf& y) { return y < x; }
  friend Truth operator<=(const BoundedOf& x, const BoundedOf& y) {
    return {x.value <= y.value, are_apart(x, y)};
  }
  friend Truth operator!=(const BoundedOf& x, const BoundedOf& y) {
    return {x.value != y.value, are_apart(x, y)};
  }

private:
  // Two numbers without error compare as their exact values do, equal ones too.
  static bool are_apart(const BoundedOf& x, const BoundedOf& y) {
    if (x.bound == 0 && y.bound == 0) return true;
    return std::abs(double(x.value) - double(y.value)) > (x.bound + y.bound) * kRoundUp;
  }
};
using Bounded = BoundedOf<float>;

template <class F>
concept Number = std::same_as<F, BoundedOf<float>> || std::same_as<F, BoundedOf<double>>;

// 0 times infinity is 0: an unknown number that is not used does no harm.
inline double times(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

// ---- what an operation rounds ----

// How far `rounded` is from `near`, which is itself within `off` of the exact result.
template <class T>
double rounding(T rounded, double near, double off) {
  return std::abs(near - double(rounded)) + off;
}

// What a sum of doubles loses, exactly (Knuth's TwoSum).
inline double lost_of_sum(double a, double b, double sum) {
  const double b_there = sum - a, a_there = sum - b_there;
  return std::abs((a - a_there) + (b - b_there));
}

inline constexpr double kHalfUlp = 0x1p-53;

// Floats only: a = b c without rounding.
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
  const double own = rounding(value, near, lost_of_sum(a, b, near));
  return {value, (x.bound + y.bound + own) * kRoundUp};
}
template <class T>
BoundedOf<T> product_of(const BoundedOf<T>& x, const BoundedOf<T>& y) {
  const T value = x.value * y.value;
  const double a = std::abs(double(x.value)), b = std::abs(double(y.value));
  // The product of two floats is a double.
  const double near = double(x.value) * double(y.value);
  // That of doubles may be too small for one, but not where a factor is 0: then nothing is rounded.
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  const double own = std::same_as<T, float> ? rounding(value, near, 0)
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
  const double own = is_exact ? 0 : rounding(value, near, size * kHalfUlp + 0x1p-1074);
  return {value, ((x.bound + times(size, y.bound)) / smallest + own) * kRoundUp};
}

// `sqrt x` stands for the root of a number that is not negative.
template <class T>
BoundedOf<T> sqrt(const BoundedOf<T>& x) {
  const T value = std::sqrt(x.value);
  const double size = double(x.value), near = std::sqrt(size);
  const double own = is_product(x.value, value, value) ? 0 : rounding(value, near, near * kHalfUlp);
  if (x.bound == 0) return {value, own * kRoundUp};
  const double inherited = x.bound <= size
                               ? x.bound / (near + std::sqrt(size - x.bound) * (1 - 0x1p-50))
                               : std::sqrt(x.bound);
  return {value, (inherited + own) * kRoundUp};
}

// ---- conditions ----

template <Number F>
F select(Truth condition, F yes, F no) {
  F chosen = condition.holds ? yes : no;
  if (condition.is_sure) return chosen;
  const F other = condition.holds ? no : yes;
  const double apart = std::abs(double(chosen.value) - double(other.value));
  const double whole = (apart + other.bound) * kRoundUp;
  return {chosen.value, whole <= chosen.bound ? chosen.bound : whole};  // NaN is no bound
}
template <Number F>
F select(bool condition, F yes, F no) {
  return condition ? yes : no;
}

// Certainly not: what is left out must not be what the exact number would have had.
inline bool none(Truth condition) {
  return !condition.holds && condition.is_sure;
}

// ---- kinds of numbers ----

inline BoundedOf<double> widened(const Bounded& x) {
  return {double(x.value), x.bound};
}
inline Bounded rounded(const BoundedOf<double>& x) {
  const float value = float(x.value);
  return {value, (x.bound + rounding(value, x.value, 0)) * kRoundUp};
}

// A whole number as the nearest float, 2^62 at most.
inline Bounded to_float(std::int64_t i) {
  const float value = float(i);
  return {value, std::abs(double(std::int64_t(value) - i))};
}

// The number that the run has, if a formula that is equal but for rounding gave `same`.
inline Bounded standing_for(float value, const Bounded& same) {
  return {value, (same.bound + std::abs(double(value) - double(same.value))) * kRoundUp};
}

#include <glassbox/base/formulas/common.h>

}  // namespace glassbox::bounded
