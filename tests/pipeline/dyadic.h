// Exact sums and products of floats and doubles, as integers times powers of two. Rationals could
// do the same, but spend most of their time on common divisors, which are powers of two here.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace glassbox::test {

class Dyadic {
public:
  Dyadic() = default;
  // `value` is any finite number.
  explicit Dyadic(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    integer_ = std::int64_t(std::ldexp(fraction, 53));
    exponent_ = exponent - 53;
  }

  bool is_zero() const { return integer_ == 0; }
  // The number rounded to double; its sign is exact.
  double value() const {
    if (is_zero()) return 0;
    // An integer of 2^1024 or more overflows a double.
    const int spare = std::max(0, int(msb(boost::multiprecision::abs(integer_))) - 500);
    const boost::multiprecision::cpp_int kept = integer_ >> spare;
    return std::ldexp(kept.convert_to<double>(), exponent_ + spare);
  }
  double size() const { return std::abs(value()); }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    product.integer_ = a.integer_ * b.integer_;
    product.exponent_ = a.exponent_ + b.exponent_;
    return product;
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, 1); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, -1); }

private:
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign) {
    if (a.is_zero() || b.is_zero()) {
      Dyadic other = a.is_zero() ? b : a;
      if (a.is_zero()) other.integer_ *= sign;
      return other;
    }
    Dyadic sum;
    sum.exponent_ = std::min(a.exponent_, b.exponent_);
    sum.integer_ = (a.integer_ << (a.exponent_ - sum.exponent_)) +
                   sign * (b.integer_ << (b.exponent_ - sum.exponent_));
    return sum;
  }

  boost::multiprecision::cpp_int integer_ = 0;
  int exponent_ = 0;
};

}  // namespace glassbox::test
