#include <glassbox/pipeline/round_trip.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/bounds.h>
#include <glassbox/pipeline/divide.h>

namespace glassbox {
namespace {

constexpr double kRoundUp = 1 + 0x1p-40;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

struct NdcAndBound {
  glm::dvec3 position{0}, bound{0};
};

// Maps a screen position and its error bound back to NDC: the inverse of to_screen.
NdcAndBound ndc_of(const Point<Screen>& screen, const glm::dvec3& bound, const Viewport& viewport) {
  NdcAndBound ndc{{0, 0, screen.z}, {0, 0, bound.z}};
  const auto turn_round = [&](int axis, double pixels, double from, double to) {
    const double span = to - from, middle = to + from;
    ndc.position[axis] = (2 * pixels - middle) / span;
    const double rounding = gamma<double>(4) * (std::abs(2 * pixels) + std::abs(middle));
    ndc.bound[axis] = (2 * bound[axis] + rounding) / std::abs(span) * kRoundUp;
  };
  turn_round(0, screen.x, viewport.left, viewport.right);
  turn_round(1, screen.y, viewport.bottom, viewport.top);
  return ndc;
}

// The three equations A p = b for the point p (round_trip.h). `slack` is how much the true p may
// violate each of them: |A p - b| <= slack, because A and b have errors.
struct Equations {
  glm::dmat3 a{0};
  glm::dvec3 b{0};
  glm::dvec3 slack{0};
};

Equations equations_of(const NdcAndBound& ndc, const ForwardTransform& forward,
                       const Point<Object>& object, double largest_w) {
  const glm::dvec4 p(std::abs(double(object.x)), std::abs(double(object.y)),
                     std::abs(double(object.z)), 1);
  Equations e;
  for (int row = 0; row < 3; ++row) {
    const double n = ndc.position[row];
    double slack = ndc.bound[row] * largest_w;
    for (int column = 0; column < 4; ++column) {
      const double m = forward.clip_from_object[column][row],
                   w = forward.clip_from_object[column][3];
      const double entry = m - n * w;
      (column < 3 ? e.a[column][row] : e.b[row]) = column < 3 ? entry : -entry;
      const double rounding = gamma<double>(2) * (std::abs(m) + std::abs(n * w));
      slack += (rounding + forward.bound[column][row] + std::abs(n) * forward.bound[column][3]) *
               p[column];
    }
    e.slack[row] = slack * kRoundUp + kSmallest;
  }
  return e;
}

// A bound of |A p - b| in one row: the computed value plus its rounding errors.
double residual(const Equations& e, const glm::dvec3& p, int row) {
  double sum = -e.b[row], size = std::abs(e.b[row]);
  for (int column = 0; column < 3; ++column) {
    sum += e.a[column][row] * p[column];
    size += std::abs(e.a[column][row] * p[column]);
  }
  return std::abs(sum) + gamma<double>(5) * size;
}

// The largest row sum of |I - N A|: how far n is from being the inverse of a. It is infinite if
// that is not below 1/2.
double distance_from_inverse(const glm::dmat3& n, const glm::dmat3& a) {
  double largest = 0;
  for (int row = 0; row < 3; ++row) {
    double row_sum = 0;
    for (int column = 0; column < 3; ++column) {
      double sum = row == column ? -1 : 0, size = row == column ? 1 : 0;
      for (int k = 0; k < 3; ++k) {
        sum += n[k][row] * a[column][k];
        size += std::abs(n[k][row] * a[column][k]);
      }
      row_sum += std::abs(sum) + gamma<double>(5) * size;
    }
    if (!(row_sum < 0.5)) return kInfinity;  // also for NaN: no bound is known
    largest = std::max(largest, row_sum);
  }
  return largest;
}

glm::dvec3 error_bound(const Equations& e, const glm::dmat3& inverse, const glm::dvec3& found) {
  const double c = distance_from_inverse(inverse, e.a);
  if (std::isinf(c)) return glm::dvec3(kInfinity);
  glm::dvec3 bound(0);
  for (int k = 0; k < 3; ++k) {
    const double open = e.slack[k] + residual(e, found, k);
    for (int row = 0; row < 3; ++row) bound[row] += std::abs(inverse[k][row]) * open;
  }
  const double largest = std::max({bound.x, bound.y, bound.z});
  for (int row = 0; row < 3; ++row) {
    bound[row] = (bound[row] + largest * c / (1 - c)) * kRoundUp + kSmallest;
    if (std::isnan(bound[row])) bound[row] = kInfinity;
  }
  return bound;
}

bool is_finite(const Point<Clip>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

}  // namespace

bool RoundTrip::is_bounded() const {
  return std::isfinite(bound.x) && std::isfinite(bound.y) && std::isfinite(bound.z);
}

std::optional<RoundTrip> round_trip(const Point<Object>& object, const Point<Clip>& clip,
                                    const glm::dvec4& clip_bound, const ForwardTransform& forward,
                                    const Viewport& viewport) {
  if (!is_finite(clip) || !(clip.w > 0)) return {};
  const NdcVertex divided = divide(clip);
  RoundTrip trip;
  trip.screen = to_screen(divided, viewport).position;
  const glm::dvec3 bound =
      screen_bound(divided.position, divide_bound(clip, clip_bound).position, viewport);
  const NdcAndBound ndc = ndc_of(trip.screen, bound, viewport);
  const Equations equations = equations_of(ndc, forward, object, double(clip.w) + clip_bound.w);

  const glm::dmat3 inverse = glm::inverse(equations.a);
  glm::dvec3 found = inverse * equations.b;
  found -= inverse * (equations.a * found - equations.b);  // one step of refinement
  trip.object = Point<Object, double>(found);
  trip.error = glm::abs(found - glm::dvec3(to_glm(object)));
  trip.bound = error_bound(equations, inverse, found);
  return trip;
}

}  // namespace glassbox
