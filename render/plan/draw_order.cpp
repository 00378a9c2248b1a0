#include <glassbox/render/plan/draw_order.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/render/plan/box_place.h>

namespace glassbox {

namespace {

// A coordinate of clip space over a box: its values at the corners, and how far the float transform may be off.
struct Coordinate {
  std::array<double, 8> at_corner{};
  double error = 0;
};

Coordinate coordinate_over(const Box<Object>& box, const Transform<Clip, Object, float>& m,
                           int row) {
  Coordinate c;
  double size = 0;
  for (int i = 0; i < 8; ++i) {
    const Point<Object, double> p = box.corner(i);
    const std::array<double, 4> terms{double(m.at(row, 0)) * p.x, double(m.at(row, 1)) * p.y,
                                      double(m.at(row, 2)) * p.z, double(m.at(row, 3))};
    c.at_corner[std::size_t(i)] = terms[0] + terms[1] + terms[2] + terms[3];
    size = std::max(
        size, std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]) + std::abs(terms[3]));
  }
  c.error =
      gamma<float>(5) * size + 4 * 0x1p-149;  // one more than the transform's: those in double
  return c;
}

// Rounded away from the range's inside.
float rounded_down(double x) {
  return std::nextafter(float(x), -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) {
  return std::nextafter(float(x), std::numeric_limits<float>::infinity());
}

}  // namespace

DepthCodes depth_codes(const Draw& draw, const View& view, DepthFormat format) {
  const Box<Object> box = anchored_box(draw);
  if (box.empty() || !draw.prepared->all_finite) return {};
  const Coordinate z = coordinate_over(box, draw.clip_from_anchored, 2);
  const Coordinate w = coordinate_over(box, draw.clip_from_anchored, 3);
  const double least_w = *std::ranges::min_element(w.at_corner) - w.error;
  if (!(least_w > (view.perspective ? view.near / 2 : 0.5))) return {};  // it reaches the eye

  // Where w > 0, z/w has its extremes over the box at corners.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < 8; ++i) {
    low = std::min(low, z.at_corner[i] / w.at_corner[i]);
    high = std::max(high, z.at_corner[i] / w.at_corner[i]);
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  // What the transform is off by; then, relative to the depth, a rounding for the divide, 8 for its interpolation
  // (interpolate.h), and 2 for each plane that may have cut, in z and in w: below 32 in all.
  const double slack =
      (z.error + largest * w.error) / least_w + 32 * unit_roundoff<float> * largest;
  const std::uint32_t a = depth_code(format, rounded_down(low - slack));
  const std::uint32_t b = depth_code(format, rounded_up(high + slack));
  return {std::min(a, b), std::max(a, b)};
}

std::size_t order_front_to_back(std::span<std::uint32_t> order, std::span<const DepthCodes> codes) {
  std::size_t moved = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t first = i > kMostOvertaken ? i - kMostOvertaken : 0;
    std::size_t to = i;
    while (to > first && may_overtake(codes[order[i]], codes[order[to - 1]])) --to;
    std::rotate(order.begin() + std::ptrdiff_t(to), order.begin() + std::ptrdiff_t(i),
                order.begin() + std::ptrdiff_t(i + 1));
    moved += to < i;
  }
  return moved;
}

}  // namespace glassbox
