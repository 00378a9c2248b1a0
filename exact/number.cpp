#include "exact/number.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace glassbox::exact {
namespace {

namespace mp = boost::multiprecision;

using Int128 = mp::checked_int128_t;
using Ratio = mp::cpp_rational;
using Digits50 = mp::cpp_bin_float_50;

template <class Kind>
struct Library;
template <>
struct Library<IntegerKind> {
  using type = Int128;
};
template <>
struct Library<RationalKind> {
  using type = Ratio;
};
template <>
struct Library<DecimalKind> {
  using type = Digits50;
};

template <class Kind>
using Inside = typename Library<Kind>::type;

template <class Kind>
Inside<Kind>& inside(Number<Kind>& number) {
  return *std::launder(static_cast<Inside<Kind>*>(number.storage()));
}
template <class Kind>
const Inside<Kind>& inside(const Number<Kind>& number) {
  return *std::launder(static_cast<const Inside<Kind>*>(number.storage()));
}

template <class Kind>
Number<Kind> wrapped(const Inside<Kind>& value) {
  Number<Kind> number;
  inside(number) = value;
  return number;
}

// The library's operations return an infinite or NaN Decimal if there is no result. This function
// throws then, so that users of Number never get one.
template <class Kind>
void require_finite(const Number<Kind>& number) {
  if constexpr (std::is_same_v<Kind, DecimalKind>) {
    if (!(mp::isfinite)(inside(number))) throw std::domain_error("no finite number");
  }
}

void require_acceptable(double value, IntegerKind) {
  if (value != std::trunc(value) || std::abs(value) >= 0x1p127) {
    throw std::range_error("not an integer of 128 bits");
  }
}
void require_acceptable(double, RationalKind) {}
void require_acceptable(double, DecimalKind) {}

double checked(double value) {
  if (!std::isfinite(value)) throw std::domain_error("infinity or NaN has no exact value");
  return value;
}

}  // namespace

template <class Kind>
Number<Kind>::Number(std::int64_t value) {
  static_assert(sizeof(Inside<Kind>) <= sizeof storage_ && alignof(Inside<Kind>) <= 16);
  ::new (storage_) Inside<Kind>(value);
}

template <class Kind>
Number<Kind>::Number(double value) {
  require_acceptable(checked(value), Kind{});
  ::new (storage_) Inside<Kind>(value);
}

template <class Kind>
Number<Kind>::Number(const Number& other) {
  ::new (storage_) Inside<Kind>(inside(other));
}

template <class Kind>
Number<Kind>& Number<Kind>::operator=(const Number& other) {
  if (this != &other) inside(*this) = inside(other);
  return *this;
}

template <class Kind>
Number<Kind>::~Number() {
  std::destroy_at(&inside(*this));
}

template <class Kind>
Number<Kind>& Number<Kind>::operator+=(const Number& other) {
  inside(*this) += inside(other);
  require_finite(*this);
  return *this;
}
template <class Kind>
Number<Kind>& Number<Kind>::operator-=(const Number& other) {
  inside(*this) -= inside(other);
  require_finite(*this);
  return *this;
}
template <class Kind>
Number<Kind>& Number<Kind>::operator*=(const Number& other) {
  inside(*this) *= inside(other);
  require_finite(*this);
  return *this;
}
template <class Kind>
Number<Kind>& Number<Kind>::operator/=(const Number& other) {
  if (other.sign() == 0) throw std::overflow_error("division by zero");
  inside(*this) /= inside(other);
  require_finite(*this);
  return *this;
}

template <class Kind>
int Number<Kind>::sign() const {
  return inside(*this).sign();
}

template <class Kind>
Number<Kind>::operator double() const {
  return inside(*this).template convert_to<double>();
}

template <class Kind>
std::string Number<Kind>::text() const {
  return inside(*this).str();
}

template <class Kind>
int Number<Kind>::compare(const Number& other) const {
  return inside(*this).compare(inside(other));
}

Rational rational_from(const Integer& a) {
  return wrapped<RationalKind>(Ratio(mp::cpp_int(inside(a))));
}
Decimal decimal_from(const Rational& a) {
  return wrapped<DecimalKind>(Digits50(mp::numerator(inside(a))) /
                              Digits50(mp::denominator(inside(a))));
}

Decimal sqrt(const Decimal& a) {
  if (a.sign() < 0) throw std::domain_error("root of a negative number");
  return wrapped<DecimalKind>(mp::sqrt(inside(a)));
}
Decimal sin(const Decimal& radians) {
  return wrapped<DecimalKind>(mp::sin(inside(radians)));
}
Decimal cos(const Decimal& radians) {
  return wrapped<DecimalKind>(mp::cos(inside(radians)));
}
Decimal tan(const Decimal& radians) {
  return wrapped<DecimalKind>(mp::tan(inside(radians)));
}
Decimal atan2(const Decimal& y, const Decimal& x) {
  return wrapped<DecimalKind>(mp::atan2(inside(y), inside(x)));
}
const Decimal& pi() {
  static const Decimal value = wrapped<DecimalKind>(mp::acos(Digits50(-1)));
  return value;
}

template <class Kind>
double error_of(double value, const Number<Kind>& exact) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  return double(abs(Number<Kind>(value) - exact));
}

template class Number<IntegerKind>;
template class Number<RationalKind>;
template class Number<DecimalKind>;
template double error_of(double, const Rational&);
template double error_of(double, const Decimal&);

}  // namespace glassbox::exact
