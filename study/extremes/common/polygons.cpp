#include "study/extremes/common/polygons.h"

#include <cmath>

#include <glassbox/base/trig.h>

namespace glassbox::study {

double angle_to(const Vector<Object, double>& v, const Vector<Object, exact::Rational>& exact) {
  using exact::Decimal;
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return kPi;
  if (v.x == 0 && v.y == 0 && v.z == 0) return kHalfPi;
  const Vector<Object, Decimal> a(Decimal(v.x), Decimal(v.y), Decimal(v.z));
  const Vector<Object, Decimal> b(exact::decimal_from(exact.x), exact::decimal_from(exact.y),
                                  exact::decimal_from(exact.z));
  const Vector<Object, Decimal> across = cross(a, b);
  return double(exact::atan2(exact::sqrt(dot(across, across)), dot(a, b)));
}

}  // namespace glassbox::study
