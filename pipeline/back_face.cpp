#include <glassbox/pipeline/back_face.h>

#include <array>
#include <cmath>
#include <limits>

#include <glassbox/base/expansion.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

Facing facing_of(double value) {
  if (value > 0) return Facing::kBack;
  return value < 0 ? Facing::kFront : Facing::kEdgeOn;
}

// The polygon's Newell vector m, computed from positions relative to the first corner. `size` is
// the same sum with all terms positive: |error of m| <= gamma_n * size, where n is the number of
// roundings in a term.
struct NewellWithSize {
  Vector<Object, double> m;
  Vector<Object, double> size;
};

NewellWithSize newell_with_size(std::span<const Point<Object>> polygon) {
  const auto relative = [&](std::size_t i) {
    const Point<Object>&p = polygon[i], &origin = polygon[0];
    return Vector<Object, double>(double(p.x) - origin.x, double(p.y) - origin.y,
                                  double(p.z) - origin.z);
  };
  NewellWithSize sum{{0, 0, 0}, {0, 0, 0}};
  Vector<Object, double> p = relative(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<Object, double> n = relative(i + 1 == polygon.size() ? 0 : i + 1);
    sum.m.x += (p.y - n.y) * (p.z + n.z);
    sum.m.y += (p.z - n.z) * (p.x + n.x);
    sum.m.z += (p.x - n.x) * (p.y + n.y);
    const Vector<Object, double> size(std::abs(p.x) + std::abs(n.x), std::abs(p.y) + std::abs(n.y),
                                      std::abs(p.z) + std::abs(n.z));
    sum.size.x += size.y * size.z;
    sum.size.y += size.z * size.x;
    sum.size.z += size.x * size.y;
    p = n;
  }
  return sum;
}

using Difference = Expansion<2>;

// An exact sum over n < 2^32 fan triangles has bits between 2^-550 and 2^520 only, because each
// term is a product of two differences of floats (bits from 2^-149 to 2^128) and one with a
// coordinate of a valid viewer (bits from 2^-252 to 2^201). No two terms of an expansion have bits
// of the same value, so 1100 terms are enough.
using FanSum = Expansion<1100>;

int exact_sign(std::span<const Point<Object>> polygon, const ObjectViewer& viewer) {
  const Point<Object>& origin = polygon[0];
  const auto relative = [&](std::size_t i) {
    const Point<Object>& p = polygon[i];
    return std::array{exact_difference(p.x, origin.x), exact_difference(p.y, origin.y),
                      exact_difference(p.z, origin.z)};
  };
  const Vector<Object, double>& v = viewer.eye_or_gaze;
  const std::array sight =
      viewer.perspective
          ? std::array{exact_difference(origin.x, v.x), exact_difference(origin.y, v.y),
                       exact_difference(origin.z, v.z)}
          : std::array{exact_difference(v.x, 0), exact_difference(v.y, 0),
                       exact_difference(v.z, 0)};
  FanSum sum;
  std::array<Difference, 3> p = relative(1);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const std::array<Difference, 3> n = relative(i);
    sum.add((p[1] * n[2] - p[2] * n[1]) * sight[0]);
    sum.add((p[2] * n[0] - p[0] * n[2]) * sight[1]);
    sum.add((p[0] * n[1] - p[1] * n[0]) * sight[2]);
    p = n;
  }
  return sum.sign();
}

// The quantities that Cramer's rule needs for three rows of a transform: for the 3x3 matrix of
// their first three columns.
struct Linear {
  std::array<std::array<double, 3>, 3> adjugate;       // adjugate * matrix = determinant * identity
  std::array<std::array<double, 3>, 3> adjugate_size;  // the adjugate with all terms positive
  double determinant;
  double determinant_size;
};

template <class Target>
Linear linear_part(const Transform<Target, Object>& t, int row0, int row1, int row2) {
  const std::array<int, 3> rows{row0, row1, row2};
  const auto at = [&](std::size_t r, std::size_t c) { return t.at(rows[r % 3], int(c % 3)); };
  Linear linear;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double plus = at(r + 1, c + 1) * at(r + 2, c + 2);
      const double minus = at(r + 1, c + 2) * at(r + 2, c + 1);
      linear.adjugate[c][r] = plus - minus;
      linear.adjugate_size[c][r] = std::abs(plus) + std::abs(minus);
    }
  }
  linear.determinant = 0;
  linear.determinant_size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    linear.determinant += at(0, c) * linear.adjugate[c][0];
    linear.determinant_size += std::abs(at(0, c)) * linear.adjugate_size[c][0];
  }
  return linear;
}

bool is_singular_within_rounding(const Linear& linear) {
  // A term of the determinant has 5 roundings: 2 in the adjugate, then a product and two sums. With
  // the factor 2, the error is less than half of a determinant that passes. The comparison is not
  // written as "<=", so that NaN means singular too.
  return !(std::abs(linear.determinant) > 2 * gamma<double>(5) * linear.determinant_size);
}

}  // namespace

std::optional<ObjectViewer> viewer_in_object_space(const Transform<Eye, Object>& eye_from_object,
                                                   bool perspective,
                                                   const Point<Eye, double>& viewpoint) {
  const Linear linear = linear_part(eye_from_object, 0, 1, 2);
  if (is_singular_within_rounding(linear)) return std::nullopt;
  // The right-hand side of the equations linear * eye_or_gaze = right.
  const std::array<double, 3> right = perspective
                                          ? std::array{viewpoint.x - eye_from_object.at(0, 3),
                                                       viewpoint.y - eye_from_object.at(1, 3),
                                                       viewpoint.z - eye_from_object.at(2, 3)}
                                          : std::array{0.0, 0.0, -1.0};
  ObjectViewer viewer;
  viewer.perspective = perspective;
  std::array<double, 3> solution, error;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += linear.adjugate[i][k] * right[k];
      size += linear.adjugate_size[i][k] * std::abs(right[k]);
    }
    solution[i] = sum / linear.determinant;
    // The numerator has 7 roundings (2 in the adjugate, one in `right`, one product, three sums),
    // the determinant 5, and the division is one more; gamma(8) is enough for each of the two
    // terms. At least half of the determinant is correct (is_singular_within_rounding), so its
    // error at most doubles both terms. 2^-200 is added because smaller coordinates are set to
    // zero.
    const double determinant = std::abs(linear.determinant);
    error[i] =
        2 * gamma<double>(8) * size / determinant +
        2 * gamma<double>(8) * std::abs(solution[i]) * (linear.determinant_size / determinant) +
        0x1p-200;
    if (std::abs(solution[i]) < 0x1p-200) solution[i] = 0;
    if (!is_exactly_computable(solution[i]) || !(error[i] <= 0x1p200)) return std::nullopt;
  }
  viewer.eye_or_gaze = {solution[0], solution[1], solution[2]};
  viewer.error = {error[0], error[1], error[2]};
  return viewer;
}

BackFaceTest test_back_face(std::span<const Point<Object>> polygon, const ObjectViewer& viewer) {
  BackFaceTest test;
  if (polygon.size() < 3) {
    test.facing = Facing::kEdgeOn;
    return test;
  }
  const NewellWithSize newell = newell_with_size(polygon);
  const Vector<Object, double>& v = viewer.eye_or_gaze;
  const Point<Object>& p = polygon[0];
  const Vector<Object, double> sight =
      viewer.perspective
          ? Vector<Object, double>(double(p.x) - v.x, double(p.y) - v.y, double(p.z) - v.z)
          : v;
  test.value = dot(newell.m, sight);
  // A term of `value` for a polygon of N corners has at most N + 9 roundings. In m: two for the
  // corners relative to the first, two for their difference and sum, one product, at most N sums.
  // Then: one for the sight, one product, two sums. `size` and this bound are rounded, too; N + 12
  // instead of N + 9 covers that.
  const double size = newell.size.x * std::abs(sight.x) + newell.size.y * std::abs(sight.y) +
                      newell.size.z * std::abs(sight.z);
  test.bound = double(polygon.size() + 12) * unit_roundoff<double> * size;
  test.viewer_error_bound =
      (1 + 0x1p-40) * (newell.size.x * viewer.error.x + newell.size.y * viewer.error.y +
                       newell.size.z * viewer.error.z);
  test.used_exact = !(std::abs(test.value) > test.bound);
  test.facing = facing_of(test.used_exact ? exact_sign(polygon, viewer) : test.value);
  return test;
}

double snapping_margin(const Transform<Clip, Object>& clip_from_object, const ObjectViewer& viewer,
                       const Viewport& viewport, double largest_w, double longest_edge_px,
                       double displacement_px) {
  const double s = displacement_px;
  const double area_change = 8 * s * longest_edge_px + 8 * s * s;
  const double half_pixels = std::abs(double(viewport.width()) * double(viewport.height())) / 4;
  double scale;
  if (viewer.perspective) {
    const Linear linear = linear_part(clip_from_object, 0, 1, 3);
    if (is_singular_within_rounding(linear)) return std::numeric_limits<double>::infinity();
    // A lower bound of the exact |determinant|: the computed one minus its error bound.
    scale = std::abs(linear.determinant) - gamma<double>(5) * linear.determinant_size;
  } else {
    const Vector<Object, double> x(clip_from_object.at(0, 0), clip_from_object.at(0, 1),
                                   clip_from_object.at(0, 2));
    const Vector<Object, double> y(clip_from_object.at(1, 0), clip_from_object.at(1, 1),
                                   clip_from_object.at(1, 2));
    const Vector<Object, double> area = cross(x, y);
    const Vector<Object, double>& g = viewer.eye_or_gaze;
    scale = std::sqrt(dot(area, area) / dot(g, g)) * (1 - 0x1p-40);
  }
  const double w = viewer.perspective ? largest_w : 1;
  // The last factor covers the few roundings in this expression.
  const double margin = area_change * (w * w * w) / (half_pixels * scale) * (1 + 0x1p-40);
  return margin >= 0 ? margin : std::numeric_limits<double>::infinity();
}

}  // namespace glassbox
