// Numbers for reference results: their arithmetic does not round, or rounds so little that it does
// not matter.
//
//   Integer    128 bits, exact; throws on overflow      everything from snapped coordinates
//   Rational   exact, of any size                       floats and doubles, + - * /
//   Decimal    50 digits or more, correctly rounded     roots, angles; long products
//
// The class Number wraps two kinds of library types: Boost.Multiprecision's integers and rationals,
// and its binary floats. Only number.cpp includes the library, because a test that included it
// would take ten times as long to compile.
#pragma once

#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>

namespace glassbox::exact {

struct IntegerKind {};
struct RationalKind {};
struct DecimalKind {};

// Can be used like a built-in number. An operation that has no result throws std::domain_error,
// std::range_error or std::overflow_error: a conversion from infinity or NaN, a conversion from a
// fraction to Integer, a division by zero, an overflow of Integer.
template <class Kind>
class Number {
public:
  Number() : Number(std::int64_t(0)) {}
  Number(std::integral auto value) : Number(std::int64_t(value)) {}
  Number(std::int64_t value);
  // Stores the value of the double without rounding.
  explicit Number(double value);
  Number(const Number& other);
  Number& operator=(const Number& other);
  ~Number();

  Number& operator+=(const Number& other);
  Number& operator-=(const Number& other);
  Number& operator*=(const Number& other);
  Number& operator/=(const Number& other);  // for Integer the quotient is rounded towards zero

  // -1, 0 or 1.
  int sign() const;
  // The nearest double.
  explicit operator double() const;
  std::string text() const;

  friend Number operator+(Number a, const Number& b) { return a += b; }
  friend Number operator-(Number a, const Number& b) { return a -= b; }
  friend Number operator*(Number a, const Number& b) { return a *= b; }
  friend Number operator/(Number a, const Number& b) { return a /= b; }
  friend Number operator-(const Number& a) { return Number() - a; }
  friend Number abs(const Number& a) { return a.sign() < 0 ? -a : a; }
  friend bool operator==(const Number& a, const Number& b) { return a.compare(b) == 0; }
  friend std::strong_ordering operator<=>(const Number& a, const Number& b) {
    return a.compare(b) <=> 0;
  }

  // The library's number is stored here. Only number.cpp looks inside.
  void* storage() { return storage_; }
  const void* storage() const { return storage_; }

private:
  int compare(const Number& other) const;

  alignas(16) std::byte storage_[96];
};

using Integer = Number<IntegerKind>;
using Rational = Number<RationalKind>;
using Decimal = Number<DecimalKind>;

// Conversions to a type that can hold more values. decimal_from rounds the quotient to Decimal's 50
// digits.
Rational rational_from(const Integer& a);
Decimal decimal_from(const Rational& a);

Decimal sqrt(const Decimal& a);
Decimal sin(const Decimal& radians);
Decimal cos(const Decimal& radians);
Decimal tan(const Decimal& radians);
Decimal atan2(const Decimal& y, const Decimal& x);
const Decimal& pi();

// 1/x; 0 for infinity.
template <class N>
N inverse_of(double x) {
  return std::isinf(x) ? N() : N(1) / N(x);
}

// |value - exact|; infinity where the value is infinite or NaN.
template <class Kind>
double error_of(double value, const Number<Kind>& exact);

extern template class Number<IntegerKind>;
extern template class Number<RationalKind>;
extern template class Number<DecimalKind>;

}  // namespace glassbox::exact
