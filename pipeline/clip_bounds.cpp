#include <glassbox/pipeline/clip_bounds.h>

#include <cmath>
#include <limits>

#include <glassbox/base/bounded.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

constexpr double kU = unit_roundoff<float>;
constexpr double kHalfSubnormal = 0x1p-150;
constexpr double kRoundUp = 1 + 0x1p-40;
// A bound of the rounding errors of crossing() (clip.cpp) in double: products, sums and a quotient.
// It is added for the weights only, which stay in double; positions are rounded to float.
constexpr double kInDouble = 8 * unit_roundoff<double>;

// The index of the coordinate that put_on_plane (clip.cpp) recomputes from the plane, or -1.
int own_coordinate(const ClipPlane& plane) {
  const int coordinates = int(plane.a != 0) + int(plane.b != 0) + int(plane.c != 0);
  if (coordinates == 0) return plane.d != 0 ? 3 : -1;
  if (coordinates > 1) return -1;
  return plane.a != 0 ? 0 : plane.b != 0 ? 1 : 2;
}

}  // namespace

double distance_bound(const ClipPlane& plane, const glm::dvec4& position_bound) {
  return (bounded::times(std::abs(plane.a), position_bound.x) +
          bounded::times(std::abs(plane.b), position_bound.y) +
          bounded::times(std::abs(plane.c), position_bound.z) +
          bounded::times(std::abs(plane.d), position_bound.w)) *
         kRoundUp;
}

ClipVertexBound crossing_bound(const ClipPlane& plane, const ClipVertex& p,
                               const ClipVertexBound& p_bound, double p_distance,
                               const ClipVertex& q, const ClipVertexBound& q_bound,
                               double q_distance, const ClipVertex& crossing) {
  const double p_size = std::abs(p_distance), q_size = std::abs(q_distance);
  const double whole = p_size + q_size, s = p_size / whole;
  const double p_open = distance_bound(plane, p_bound.position);
  const double q_open = distance_bound(plane, q_bound.position);
  const double least = whole - p_open - q_open;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(least > 0)) return {glm::dvec4(kInfinity), glm::dvec3(kInfinity)};
  const double ds = (q_size * p_open + p_size * q_open) / (whole * least);
  const auto between = [&](double at_p, double p_off, double at_q, double q_off) {
    return bounded::times(1 - s + ds, p_off) + bounded::times(s + ds, q_off) +
           ds * std::abs(at_q - at_p);
  };

  ClipVertexBound bound;
  const glm::vec4 a = to_glm(p.position), b = to_glm(q.position), x = to_glm(crossing.position);
  for (int i = 0; i < 4; ++i) {
    const double inherited =
        between(double(a[i]), p_bound.position[i], double(b[i]), q_bound.position[i]);
    bound.position[i] = (inherited + kU * std::abs(double(x[i])) + kHalfSubnormal) * kRoundUp;
  }
  const int own = own_coordinate(plane);
  if (own == 3) {
    bound.position.w = 0;  // w was set to -e/d, which is a float
  } else if (own >= 0) {
    const double coefficient = std::abs(own == 0 ? plane.a : own == 1 ? plane.b : plane.c);
    const double slope = std::abs(plane.d) / coefficient;
    const bool exact = plane.e == 0 && (slope == 0 || slope == 1);
    const double rounding = exact ? 0 : kU * std::abs(double(x[own])) + kHalfSubnormal;
    bound.position[own] = (bounded::times(slope, bound.position.w) + rounding) * kRoundUp;
  }
  for (int i = 0; i < 3; ++i) {
    const std::size_t k = std::size_t(i);
    bound.weights[i] =
        (between(p.weights[k], p_bound.weights[i], q.weights[k], q_bound.weights[i]) + kInDouble) *
        kRoundUp;
  }
  return bound;
}

}  // namespace glassbox
