#include <glassbox/raster/bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/bounded.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

constexpr double kU = unit_roundoff<float>;
// The error bounds of formulas/interpolate.h hold to first order in u (the unit roundoff, 2^-24).
// This factor covers the higher orders and the rounding errors of the bounds themselves.
constexpr double kRoundUp = 1 + 0x1p-18;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns the largest relative error of 1/w at the three vertices.
double relative_inverse_w(const TriangleSetup& setup, const SetupBounds& vertices) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    largest = std::max(largest, vertices.inverse_w[k] / std::abs(double(setup.inverse_w[k])));
  }
  return largest;
}

// The relative error that a weight inherits from the errors of the vertices' 1/w, whose largest
// relative error is r. The weight is lambda_k/w_k over the sum of all three such terms, and each
// term is wrong by a factor between 1 - r and 1 + r. This also holds where the three computed w are
// equal and the screen weights are used: if the true w differ a little, so do the true weights.
double inherited_share(double r) {
  return r < 1 ? 2 * r / (1 - r) : kInfinity;
}

}  // namespace

FragmentBounds fragment_bounds(const TriangleSetup& setup, const Fragment& fragment,
                               const SetupBounds& vertices) {
  const double r = relative_inverse_w(setup, vertices);
  const double weight_roundings = setup.affine ? 4 : 10;
  FragmentBounds bounds;
  double depth = 0, inverse_w = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double lambda = std::abs(double(fragment.lambda[k]));
    const double weight = std::abs(double(fragment.weights[k]));
    bounds.lambda[k] = 4 * kU * lambda * kRoundUp;
    bounds.weights[k] =
        (weight_roundings * kU * weight + bounded::times(weight, inherited_share(r))) * kRoundUp;
    depth += bounded::times(lambda, vertices.depth[k]);
    inverse_w += bounded::times(lambda, vertices.inverse_w[k]);
  }
  bounds.depth = (8 * kU * std::abs(double(fragment.depth)) + depth) * kRoundUp;
  const double q = std::abs(double(fragment.inverse_w));
  bounds.inverse_w = ((setup.affine ? 0 : 7 * kU * q) + inverse_w) * kRoundUp;
  // With the computed q' (here `q`) and the exact q, |1/q' - 1/q| = |q - q'|/(q q'), and the exact
  // q is at least q' minus its bound.
  const double smallest_q = q - bounds.inverse_w;
  bounds.distance = smallest_q > 0 ? bounds.inverse_w / (q * smallest_q) * kRoundUp : kInfinity;
  return bounds;
}

double attribute_bound(const std::array<float, 3>& values, const std::array<double, 3>& bounds,
                       const TriangleSetup& setup, const Fragment& fragment,
                       const SetupBounds& vertices) {
  const double share = inherited_share(relative_inverse_w(setup, vertices));
  double own = 0, inherited = 0;
  double value = double(values[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = double(fragment.weights[k]);
    const double difference = double(values[k]) - double(values[0]);
    value += weight * difference;
    own += 13 * kU * weight * std::abs(difference);
    inherited +=
        bounded::times(weight, bounds[k]) + bounded::times(weight * std::abs(difference), share);
  }
  return (own + kU * std::abs(value) + inherited) * kRoundUp;
}

double distance_of_depth(double distance, double near, double far, double depth_bound) {
  const double slope = std::isinf(far) ? 1 / near : (far - near) / (far * near);
  return distance * distance * slope * depth_bound;
}

double share_of_distance(double first_order) {
  return first_order < 1 ? first_order / (1 - first_order) * kRoundUp : kInfinity;
}

double area_bound(const std::array<ScreenVertex, 3>& vertices, double displacement) {
  const auto length = [&](std::size_t a, std::size_t b) {
    return std::abs(double(vertices[a].position.x) - double(vertices[b].position.x)) +
           std::abs(double(vertices[a].position.y) - double(vertices[b].position.y));
  };
  return (2 * displacement * (length(0, 1) + length(0, 2)) + 8 * displacement * displacement) *
         kRoundUp;
}

}  // namespace glassbox
