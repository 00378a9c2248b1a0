// Signs of sums of products of floats, without rounding.
//
// The product of two floats has 48 significant bits at most and its exponent cannot leave double's range, so it is a
// double exactly. What remains is to add doubles exactly: ExactSum keeps the total as a list of doubles that do not
// overlap (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates").
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace glassbox {

class ExactSum {
public:
  // Shewchuk's GROW-EXPANSION without the zeros: each partial sum and its rounding error replace the pair they came
  // from.
  void add(double term) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const double sum = term + part;
      const double part_share = sum - term;
      const double error = (term - (sum - part_share)) + (part - part_share);
      if (error != 0) parts_[kept++] = error;
      term = sum;
    }
    parts_.resize(kept);
    if (term != 0) parts_.push_back(term);
  }
  void add_product(float a, float b) { add(double(a) * double(b)); }
  void subtract_product(float a, float b) { add(-(double(a) * double(b))); }

  // The last part outweighs all others together.
  int sign() const {
    if (parts_.empty()) return 0;
    return parts_.back() > 0 ? 1 : -1;
  }
  // The total to within an ulp or so, with the right sign.
  double approximation() const {
    double total = 0;
    for (const double part : parts_) total += part;
    return total;
  }

private:
  std::vector<double> parts_;  // ascending in magnitude
};

// A point of the plane with float coordinates.
struct FlatPoint {
  float x = 0, y = 0;
  friend bool operator==(const FlatPoint&, const FlatPoint&) = default;
};

// +1 where a, b, c turn counter-clockwise, -1 clockwise, 0 exactly where they are collinear.
inline int orientation(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  const double left = (double(a.x) - c.x) * (double(b.y) - c.y);
  const double right = (double(a.y) - c.y) * (double(b.x) - c.x);
  const double determinant = left - right;
  // Shewchuk's bound for this expression is (3 + 16 u) u (|left| + |right|) with u = 2^-53; 4 u covers it. Nothing
  // underflows: non-zero differences of floats are at least 2^-149.
  const double bound = 0x1p-51 * (std::abs(left) + std::abs(right));
  if (determinant > bound) return 1;
  if (-determinant > bound) return -1;
  ExactSum exact;
  exact.add_product(a.x, b.y);
  exact.subtract_product(a.y, b.x);
  exact.add_product(b.x, c.y);
  exact.subtract_product(b.y, c.x);
  exact.add_product(c.x, a.y);
  exact.subtract_product(c.y, a.x);
  return exact.sign();
}

}  // namespace glassbox
