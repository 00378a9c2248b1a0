#include "study/stiffness/condition_formulas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/raster/bounds.h>

namespace glassbox::study {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Enlarges a bound, to cover the formulas' own rounding errors in double, and the terms that a
// first-order formula omits for numbers below 2^-20.
constexpr double kRoundUp = 1 + 0x1p-18;

double half_ulp(float x) {
  return double(ulp(x)) / 2;
}

// Twice the area of a triangle, and its longest side.
struct Shape {
  double double_area = 0, longest = 0;
};

Shape shape_of(const std::array<std::array<double, 2>, 3>& p) {
  Shape shape;
  const auto difference = [&](std::size_t a, std::size_t b) {
    return std::array{p[b][0] - p[a][0], p[b][1] - p[a][1]};
  };
  const auto u = difference(0, 1), v = difference(0, 2);
  shape.double_area = std::abs(u[0] * v[1] - u[1] * v[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto side = difference(k, (k + 1) % 3);
    shape.longest = std::max(shape.longest, std::hypot(side[0], side[1]));
  }
  return shape;
}

}  // namespace

double pixels_per_unit(const View& view) {
  return std::abs(view.clip_from_eye.at(1, 1)) *
         std::abs(double(view.viewport.bottom) - double(view.viewport.top)) / 2;
}

double depth_share(const View& view, DepthFormat format, double depth, double distance,
                   double ndc_bound) {
  const bool whole = format == DepthFormat::kUnorm24 || format == DepthFormat::kUnorm16;
  const double step = whole ? 0.5 / unorm_depth_steps(format) : 0;
  const double bound = ndc_bound + 8 * unit_roundoff<float> * std::abs(depth) + step;
  return share_of_distance(distance_of_depth(distance, view.near, view.far, bound) / distance) *
         kRoundUp;
}

double half_ulp_on_screen(const Transform<Clip, Object>& clip_from_object,
                          const Point<Object>& position, const Viewport& viewport) {
  const Point<Object, double> object(double(position.x), double(position.y), double(position.z));
  const Point<Clip, double> clip = clip_from_object * object;
  const auto moved = [&](int row) {
    return std::abs(clip_from_object.at(row, 0)) * half_ulp(position.x) +
           std::abs(clip_from_object.at(row, 1)) * half_ulp(position.y) +
           std::abs(clip_from_object.at(row, 2)) * half_ulp(position.z);
  };
  const double w = std::abs(clip.w) - moved(3);
  if (!(w > 0)) return kInfinity;
  const auto pixels = [&](int row, double coordinate, double side) {
    return side / 2 * (moved(row) + std::abs(coordinate / clip.w) * moved(3)) / w * kRoundUp;
  };
  return std::max(pixels(0, clip.x, std::abs(double(viewport.right) - double(viewport.left))),
                  pixels(1, clip.y, std::abs(double(viewport.bottom) - double(viewport.top))));
}

double sliver_factor(const std::array<std::array<double, 2>, 3>& triangle) {
  const Shape shape = shape_of(triangle);
  return shape.double_area > 0 ? shape.longest * shape.longest / shape.double_area : kInfinity;
}

double sliver_share(const std::array<std::array<double, 2>, 3>& triangle, double moved) {
  const Shape shape = shape_of(triangle);
  if (!(shape.longest > 0)) return kInfinity;
  // The smallest height of a triangle is the height over its longest side.
  const double d = std::sqrt(2.0) * moved;
  const double height = shape.double_area / shape.longest * (1 - 0x1p-40) - 2 * d;
  return height > 0 ? d / height * kRoundUp : kInfinity;
}

UpAngle up_angle(const Vector<World, double>& gaze, const Vector<World, double>& up,
                 const View& view) {
  const Vector<World, double> across = cross(gaze, up);
  UpAngle angle;
  angle.sine = std::sqrt(dot(across, across) / (dot(gaze, gaze) * dot(up, up)));
  const double entry = (8 + 4 / angle.sine) * unit_roundoff<double>;
  const double width = std::abs(double(view.viewport.right) - double(view.viewport.left));
  const double height = std::abs(double(view.viewport.bottom) - double(view.viewport.top));
  const double half_diagonal = std::hypot(width, height) / 2;
  // A parallel view has no focal length; the half diagonal is used in its place, because a wrong
  // angle turns the picture about its centre.
  const double focal = view.perspective ? pixels_per_unit(view) : half_diagonal;
  angle.pixels = 3 * entry * (focal + half_diagonal * half_diagonal / focal) * kRoundUp;
  return angle;
}

double half_ulp_in_texels(float coordinate, int size) {
  return half_ulp(coordinate) * size;
}

}  // namespace glassbox::study
