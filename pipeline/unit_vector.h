// Converts directions of any length to length 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glassbox/base/spaces.h>

namespace glassbox {

// v / |v|, each component with a relative error of at most 3 u (u is the unit roundoff, 2^-53).
// Returns nothing for a zero, infinite or NaN vector, nor for one so short that its components are
// subnormal (a processor that flushes those to zero gives the same answer). The largest component
// is first scaled to [1/2, 1) by a power of two, so that no length overflows or underflows and v
// and 2^k v give the same bytes. A vector along an axis gives exactly 0 and +-1.
template <class Space>
std::optional<Vector<Space, double>> unit(const Vector<Space, double>& v) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest < std::numeric_limits<double>::min()) return std::nullopt;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Vector<Space, double> scaled{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent),
                                     std::ldexp(v.z, -exponent)};
  const double length = std::sqrt(dot(scaled, scaled));
  return Vector<Space, double>{scaled.x / length, scaled.y / length, scaled.z / length};
}

}  // namespace glassbox
