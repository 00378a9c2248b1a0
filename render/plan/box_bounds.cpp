#include <glassbox/render/plan/box_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/render/plan/box_classification.h>

namespace glassbox {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ClipCoordinate coordinate_over(const Box<Object>& box, const Transform<Clip, Object, float>& m,
                               int row) {
  ClipCoordinate c;
  double& size = c.largest_term;
  for (int i = 0; i < 8; ++i) {
    const Point<Object, double> p = box.corner(i);
    const std::array<double, 4> terms{double(m.at(row, 0)) * p.x, double(m.at(row, 1)) * p.y,
                                      double(m.at(row, 2)) * p.z, double(m.at(row, 3))};
    c.at_corner[std::size_t(i)] = terms[0] + terms[1] + terms[2] + terms[3];
    size = std::max(
        size, std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]) + std::abs(terms[3]));
  }
  // The transform in float has four roundings; gamma(5) allows one more, for the rounding errors of
  // this computation in double. 4 * 2^-149 covers products that are subnormal.
  c.error = gamma<float>(5) * size + 4 * 0x1p-149;
  return c;
}

// The coordinate w over a box that is wholly in front of the eye.
struct BeforeTheEye {
  ClipCoordinate w;
  double least_w = 0;
};
std::optional<BeforeTheEye> before_the_eye(const ClipCoordinate& w, const View& view) {
  const double least_w = *std::ranges::min_element(w.at_corner) - w.error;
  if (!(least_w > (view.perspective ? view.near / 2 : 0.5))) return std::nullopt;
  return BeforeTheEye{w, least_w};
}
std::optional<BeforeTheEye> before_the_eye(const Draw& draw, const Box<Object>& box,
                                           const View& view) {
  if (box.empty() || !draw.prepared->all_finite) return std::nullopt;
  return before_the_eye(coordinate_over(box, draw.clip_from_anchored, 3), view);
}

struct Range {
  double low = kInfinity, high = -kInfinity;
  double largest() const { return std::max(std::abs(low), std::abs(high)); }
  bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }
  Range widened(double by) const { return {low - by, high + by}; }
};

// Returns the range of coordinate / w over the box. Since w > 0, its extremes are at corners. The
// error of the transform is included.
Range quotients(const ClipCoordinate& coordinate, const BeforeTheEye& eye) {
  Range range;
  for (std::size_t i = 0; i < 8; ++i) {
    const double quotient = coordinate.at_corner[i] / eye.w.at_corner[i];
    range.low = std::min(range.low, quotient);
    range.high = std::max(range.high, quotient);
  }
  return range.widened((coordinate.error + range.largest() * eye.w.error) / eye.least_w);
}

// rounded_down() and rounded_up() round away from the inside of a range, so that the range stays
// complete.
float rounded_down(double x) {
  return std::nextafter(float(x), -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) {
  return std::nextafter(float(x), std::numeric_limits<float>::infinity());
}

DepthCodes codes_of(const Range& depths, DepthFormat format) {
  const std::uint32_t a = depth_code(format, rounded_down(depths.low));
  const std::uint32_t b = depth_code(format, rounded_up(depths.high));
  return {std::min(a, b), std::max(a, b)};
}

// Returns the first pixel of a range in NDC and one past its last pixel. `at_minus_one` and
// `at_one` are the pixel coordinates of -1 and 1 in NDC.
std::array<int, 2> pixels_between(const Range& ndc, float at_minus_one, float at_one,
                                  double margin_px) {
  const auto on_screen = [&](double x) {
    const double px = at_minus_one + (x + 1) / 2 * (double(at_one) - double(at_minus_one));
    return std::clamp(px, -2 * kGuardBandPx, 2 * kGuardBandPx);  // nothing beyond is visible
  };
  const auto [low, high] = std::minmax({on_screen(ndc.low), on_screen(ndc.high)});
  return {int(std::floor(low - margin_px)), int(std::ceil(high + margin_px))};
}

}  // namespace

DepthCodes depth_codes(const ClipCoordinate& z, const ClipCoordinate& w, const View& view,
                       DepthFormat format) {
  const std::optional<BeforeTheEye> eye = before_the_eye(w, view);
  if (!eye) return {};
  const Range depths = quotients(z, *eye);
  // Relative to the depth, in units of u (the unit roundoff, 2^-24), the errors are 1 for the
  // divide, 8 for the interpolation (interpolate.h), and 2 for each of up to 7 planes that may have
  // cut the triangle (one in z and one in w): 23 in all. 32 also covers higher orders.
  return codes_of(depths.widened(32 * unit_roundoff<float> * depths.largest()), format);
}

DepthCodes depth_codes(const Draw& draw, const View& view, DepthFormat format) {
  const Box<Object> box = anchored_box(draw);
  if (box.empty() || !draw.prepared->all_finite) return {};
  const Transform<Clip, Object, float>& m = draw.clip_from_anchored;
  return depth_codes(coordinate_over(box, m, 2), coordinate_over(box, m, 3), view, format);
}

DepthCodes depth_codes(const TriangleSetup& triangle, DepthFormat format) {
  Range depths{double(*std::ranges::min_element(triangle.depth)),
               double(*std::ranges::max_element(triangle.depth))};
  // The interpolation (interpolate.h) has a relative error of 8 u to first order (u is the unit
  // roundoff); one more u covers the higher orders.
  depths = depths.widened(9 * unit_roundoff<float> * depths.largest());
  return codes_of(depths, format);
}

std::optional<PixelRect> pixels_of_box(const Draw& draw, const View& view, double margin_px) {
  const Box<Object> box = anchored_box(draw);
  const std::optional<BeforeTheEye> eye = before_the_eye(draw, box, view);
  if (!eye) return std::nullopt;
  const Transform<Clip, Object, float>& m = draw.clip_from_anchored;
  const Range x = quotients(coordinate_over(box, m, 0), *eye);
  const Range y = quotients(coordinate_over(box, m, 1), *eye);
  if (!x.is_finite() || !y.is_finite()) return std::nullopt;
  const Viewport& v = view.viewport;
  const auto [x0, x1] = pixels_between(x, v.left, v.right, margin_px);
  const auto [y0, y1] = pixels_between(y, v.bottom, v.top, margin_px);
  return PixelRect{x0, y0, x1, y1};
}

}  // namespace glassbox
