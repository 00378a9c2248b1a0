#include <glassbox/render/plan/group_classifier.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/elementary.h>
#include <glassbox/base/rounding.h>

namespace glassbox {

// The proof. Let X be a vertex of an instance of the group in world space and x the same vertex
// relative to the anchor of its mesh. Let P, E and W be the matrices of projection, view and
// instance in double, and M their product with the anchor's translation, rounded to float: vertices
// are multiplied by M. In exact arithmetic coordinate r of clip space is q . X + q3, where q is the
// first three entries of row r of P E. So over the group's box its extremes are at corners. The
// coordinate that is computed with M differs from it by at most the sum of these errors, where
// gamma_n = n u / (1 - n u) and u is the unit roundoff, 2^-24 (in D, 2^-53):
//
//   gamma_4 S  the float product, S = sum |M_k| |x_k| + |M_3| (PlaneOverBoxes of clip.h)
//   u S        the rounding of M
//   D          the operations in double: gamma_20 of the sum of their terms' sizes
//   tiny       4 2^-149 for products that are subnormal, and 2^-150 |x_k| for entries of M
//              that are subnormal
//
// M_k = q . W_k, so by Cauchy's inequality sum |M_k| |x_k| <= |q| reach (InstanceGroup::reach). M_3
// is the coordinate of the anchor, whose distance from X is at most reach, so |M_3| <= |coordinate
// at X| + |q| reach. Therefore S <= largest coordinate over the box + 2 |q| reach.

namespace {

constexpr double kLargestFloat = std::numeric_limits<float>::max();

// The range of the signed distance a x + b y + c z + d w + e from a clip plane over a box.
struct Distances {
  double least = 0, greatest = 0;
};
Distances distances_over(const ClipPlane& plane, const std::array<ClipCoordinate, 4>& clip) {
  Distances found{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  const std::array<double, 4> coefficients{plane.a, plane.b, plane.c, plane.d};
  double error = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double distance = plane.e, size = std::abs(plane.e);
    for (std::size_t row = 0; row < 4; ++row) {
      const double term = coefficients[row] * clip[row].at_corner[corner];
      distance += term;
      size += std::abs(term);
    }
    found.least = std::min(found.least, distance);
    found.greatest = std::max(found.greatest, distance);
    error = std::max(error, gamma<double>(8) * size);  // the rounding error of this sum
  }
  for (std::size_t row = 0; row < 4; ++row) {
    error += std::abs(coefficients[row]) * clip[row].error * (1 + gamma<double>(8));
  }
  return {found.least - error, found.greatest + error};
}

}  // namespace

GroupClassifier::GroupClassifier(const View& view) : view_(view) {
  const Transform<Clip, Eye>& p = view.clip_from_eye;
  const Transform<Eye, World>& e = view.eye_from_world;
  const Transform<Clip, World> clip_from_world = p * e;
  for (int r = 0; r < 4; ++r) {
    Row& row = rows_[std::size_t(r)];
    for (int k = 0; k < 3; ++k) row.slope[std::size_t(k)] = clip_from_world.at(r, k);
    row.offset = clip_from_world.at(r, 3);
    row.length = hypotenuse(row.slope[0], row.slope[1], row.slope[2]) * (1 + gamma<double>(16));
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 3; ++k) row.by_far += std::abs(p.at(r, j) * e.at(j, k));
      row.by_one += std::abs(p.at(r, j) * e.at(j, 3));
    }
  }
  const auto edges = picture_edges(view.viewport, kOutsideMarginPx);
  const auto planes = render_planes(view);
  const auto guard_band = planes.begin() + kFarPlane + 1;
  near_eye_far_.assign(planes.begin(), guard_band);
  edges_.assign(edges.begin(), edges.end());
  edges_.insert(edges_.end(), guard_band, planes.end());
}

ClipCoordinate GroupClassifier::coordinate_over(const InstanceGroup& group, const Row& row) const {
  ClipCoordinate c;
  double largest = 0;
  for (int i = 0; i < 8; ++i) {
    const Point<World, double> p = group.box.corner(i);
    const double value = row.slope[0] * p.x + row.slope[1] * p.y + row.slope[2] * p.z + row.offset;
    c.at_corner[std::size_t(i)] = value;
    largest = std::max(largest, std::abs(value));
  }
  const double in_double = gamma<double>(32) * (row.by_far * group.far + row.by_one);
  const double size = largest + 2 * row.length * group.reach + in_double;
  // The proof above has five roundings in float; gamma(6) allows one more, for the rounding errors
  // of this function.
  c.error = gamma<float>(6) * size + in_double + (1 + group.sizes) * (8 * 0x1p-149);
  c.largest_term = std::max(size, row.length * group.column);
  return c;
}

std::optional<BoxClassification> GroupClassifier::classify(const InstanceGroup& group) const {
  if (!group.all_finite || group.box.empty()) return std::nullopt;
  std::array<ClipCoordinate, 4> clip;
  for (std::size_t row = 0; row < 4; ++row) {
    clip[row] = coordinate_over(group, rows_[row]);
    if (!(clip[row].largest_term < kLargestFloat / 16)) return std::nullopt;  // also if it is NaN
  }
  BoxClassification classification;
  classification.of_group = true;
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = true;
  const auto look_at = [&](const ClipPlane& plane, bool counts) {
    const Distances distances = glassbox::distances_over(plane, clip);
    inside = inside && distances.least >= 0;
    if (counts) nearest = std::min(nearest, distances.least);
    if (distances.greatest >= 0) return false;
    classification.outside_of = plane.name;
    classification.distance = -distances.greatest;
    return true;
  };
  for (const ClipPlane& plane : near_eye_far_) {
    if (look_at(plane, true)) return classification;
  }
  for (const ClipPlane& plane : edges_) {
    if (look_at(plane, false)) return classification;
  }
  if (!inside) return std::nullopt;
  classification.inside = classification.in_picture = classification.in_guard_band = true;
  classification.distance = nearest;
  return classification;
}

DepthCodes GroupClassifier::codes(const InstanceGroup& group, DepthFormat format) const {
  if (!group.all_finite || group.box.empty()) return {};
  return depth_codes(coordinate_over(group, rows_[2]), coordinate_over(group, rows_[3]), view_,
                     format);
}

}  // namespace glassbox
