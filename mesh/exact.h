// Exact decisions about points in a plane that have float coordinates: rounding has no influence.
#pragma once

#include <glassbox/base/expansion.h>

namespace glassbox {

// A point of the plane with float coordinates.
struct FlatPoint {
  float x = 0, y = 0;
  friend bool operator==(const FlatPoint&, const FlatPoint&) = default;
};

// Returns +1 if the turn a, b, c is counter-clockwise, -1 if clockwise, 0 if the points are exactly
// collinear.
inline int orientation(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return sign_of_orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
}

// The exact sum of any number of products of two floats. Each product is exact in double: 48
// significant bits, and an exponent within double's range. The sum has bits from 2^-298 (the square
// of the smallest float) to 2^(256 + 33) (2^33 of the largest products). Each of its terms takes at
// least two of these 587 bit positions, which bounds the number of terms.
class ExactSum {
public:
  void add(double product) { terms_.add(product); }
  void add_product(float a, float b) { add(double(a) * double(b)); }
  void subtract_product(float a, float b) { add(-(double(a) * double(b))); }

  int sign() const { return terms_.sign(); }
  // The sum rounded to a double with an error of a few units in the last place and the correct
  // sign.
  double approximation() const { return terms_.estimate(); }

private:
  Expansion<300> terms_;
};

}  // namespace glassbox
