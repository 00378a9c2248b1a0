#include <glassbox/pipeline/bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/bounded.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

constexpr double kU = unit_roundoff<float>;
// The most that underflow can change one product or quotient.
constexpr double kHalfSubnormal = 0x1p-150;
constexpr double kRoundUp = 1 + 0x1p-40;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The rounding error of the float product a * b. It is exact, because the product of two floats
// fits into a double.
double rounding_of_product(float a, float b) {
  return std::abs(double(a) * double(b) - double(a * b));
}

}  // namespace

glm::dvec4 magnitude(const glm::dmat4& m, const glm::dvec4& x) {
  glm::dvec4 sum(0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      sum[row] += std::abs(bounded::times(m[column][row], x[column]));
  }
  return sum * kRoundUp;
}

glm::dvec4 transform_bound(const glm::mat4& m, const glm::vec4& x, const glm::dvec4& x_bound,
                           const glm::dmat4& m_bound) {
  glm::dvec4 bound;
  for (int row = 0; row < 4; ++row) {
    int products = 0, last = 0;
    double size = 0, inherited = 0;
    for (int column = 0; column < 4; ++column) {
      const double entry = std::abs(double(m[column][row]));
      const double coordinate = std::abs(double(x[column]));
      if (entry != 0 && coordinate != 0) {
        ++products;
        last = column;
        size += entry * coordinate;
      }
      inherited += bounded::times(entry, x_bound[column]);
      inherited += bounded::times(m_bound[column][row], coordinate + x_bound[column]);
    }
    const double own = products == 1 ? rounding_of_product(m[last][row], x[last])
                                     : gamma<float>(products) * size + products * kHalfSubnormal;
    bound[row] = (own + inherited) * kRoundUp;
  }
  return bound;
}

glm::dmat4 rounding_bound(const glm::dmat4& m) {
  glm::dmat4 bound;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      bound[column][row] = std::abs(m[column][row] - double(float(m[column][row])));
    }
  }
  return bound;
}

glm::dmat4 product_bound(const glm::dmat4& a, const glm::dmat4& b, const glm::dmat4& a_bound,
                         const glm::dmat4& b_bound) {
  glm::dmat4 bound(0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double size = 0, inherited = 0;
      for (int k = 0; k < 4; ++k) {
        const double left = std::abs(a[k][row]), right = std::abs(b[column][k]);
        size += bounded::times(left, right);
        inherited += bounded::times(left, b_bound[column][k]);
        inherited += bounded::times(a_bound[k][row], right + b_bound[column][k]);
      }
      bound[column][row] = (gamma<double>(4) * size + inherited) * kRoundUp;
    }
  }
  return bound;
}

DivideBound divide_bound(const Point<Clip>& clip, const glm::dvec4& clip_bound) {
  // Let x' and w' be the computed values, x = x' + ex and w = w' + ew the exact ones. Then x/w -
  // x'/w' = (ex - (x'/w') ew)/w, and |w| >= |w'| - |ew|.
  const double w = std::abs(double(clip.w));
  const double smallest_w = w - clip_bound.w;
  if (!(smallest_w > 0)) return {glm::dvec3(kInfinity), kInfinity};
  const double rounding = clip.w == 1 ? 0 : kU;
  const double underflow = clip.w == 1 ? 0 : kHalfSubnormal;
  const auto bound = [&](double coordinate, double coordinate_bound) {
    if (coordinate == 0 && coordinate_bound == 0) return 0.0;
    const double quotient = std::abs(coordinate) / w;
    return ((coordinate_bound + bounded::times(quotient, clip_bound.w)) / smallest_w +
            rounding * quotient + underflow) *
           kRoundUp;
  };
  return {{bound(clip.x, clip_bound.x), bound(clip.y, clip_bound.y), bound(clip.z, clip_bound.z)},
          bound(1, 0)};
}

glm::dvec3 divide_condition(const Point<Clip>& clip, const glm::dvec4& clip_magnitude) {
  const double w = std::abs(double(clip.w));
  if (!(w > 0)) return glm::dvec3(kInfinity);
  const auto condition = [&](double coordinate, double size) {
    return (size + std::abs(coordinate) / w * clip_magnitude.w) / w;
  };
  return {condition(clip.x, clip_magnitude.x), condition(clip.y, clip_magnitude.y),
          condition(clip.z, clip_magnitude.z)};
}

glm::dvec3 screen_bound(const Point<Ndc>& ndc, const glm::dvec3& ndc_bound,
                        const Viewport& viewport) {
  // `from` and `to` are the pixel coordinates of NDC -1 and 1. As in to_screen, the scale is (to -
  // from)/2, and the centre is their mean.
  const auto bound = [](float coordinate, double coordinate_bound, float from, float to) {
    const double scale = (to - from) * 0.5f, centre = (to + from) * 0.5f;
    const double scale_bound = std::abs(scale - (double(to) - double(from)) / 2);
    const double centre_bound = std::abs(centre - (double(to) + double(from)) / 2);
    const double x = std::abs(double(coordinate));
    return (std::abs(scale) * coordinate_bound + bounded::times(scale_bound, x + coordinate_bound) +
            centre_bound + 2 * kU * (std::abs(scale) * x * (1 + kU) + std::abs(centre)) +
            kHalfSubnormal) *
           kRoundUp;
  };
  return {bound(ndc.x, ndc_bound.x, viewport.left, viewport.right),
          bound(ndc.y, ndc_bound.y, viewport.bottom, viewport.top), ndc_bound.z};
}

SnapStability snap_stability(float pixels, double bound) {
  // This is exact: 256 is a power of two, and the bits of the float and of 0.5 fit into a double.
  const double scaled = double(pixels) * 256 + 0.5;
  const double below = std::floor(scaled);
  SnapStability snap;
  snap.snapped = below / 256;
  snap.to_boundary = std::min(scaled - below, below + 1 - scaled) / 256;
  snap.stable = snap.to_boundary > bound;
  return snap;
}

}  // namespace glassbox
