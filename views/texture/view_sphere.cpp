#include "views/texture/view_sphere.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

__extension__ using Wide = __int128;
using IntegerPoint = std::array<std::int64_t, 3>;

// A direction as whole numbers, in units of 2^-24. Each direction is moved by up to 2^-18 in its
// own way, so that no four are in one plane. This decides which of the possible triangulations of
// four views on a circle is taken. Differences of coordinates have 26 bits, the determinant in
// side_of() has 81.
IntegerPoint integer_point(const Vector3d& direction, std::uint64_t number, std::uint64_t round) {
  std::uint64_t hash = (number + 1) * 0x9e3779b97f4a7c15u + round * 0xbf58476d1ce4e5b9u;
  hash ^= hash >> 29;
  hash *= 0x94d049bb133111ebu;
  hash ^= hash >> 32;
  IntegerPoint point{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[axis] = std::llround(direction[Eigen::Index(axis)] * 0x1p24) +
                  std::int64_t(hash >> (6 * axis) & 63) - 32;
  return point;
}

// The sign of the volume of the tetrahedron a, b, c, d: positive if a, b, c are counter-clockwise
// seen from the side where d is not.
int side_of(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
            const IntegerPoint& d) {
  const auto less = [&](const IntegerPoint& p) {
    return IntegerPoint{p[0] - d[0], p[1] - d[1], p[2] - d[2]};
  };
  const IntegerPoint u = less(a), v = less(b), w = less(c);
  const Wide volume = Wide(u[0]) * (v[1] * w[2] - v[2] * w[1]) +
                      Wide(u[1]) * (v[2] * w[0] - v[0] * w[2]) +
                      Wide(u[2]) * (v[0] * w[1] - v[1] * w[0]);
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

using SphereFace = std::array<std::size_t, 3>;

// Faces of the convex hull, counter-clockwise seen from outside; none if four points that are
// tested are in one plane.
std::optional<std::vector<SphereFace>> hull_of(const std::vector<IntegerPoint>& points) {
  std::vector<SphereFace> faces;
  const int first = side_of(points[0], points[1], points[2], points[3]);
  if (first == 0) return std::nullopt;
  SphereFace base{0, 1, 2};
  if (first < 0) std::swap(base[1], base[2]);
  faces = {base, {base[1], base[0], 3}, {base[2], base[1], 3}, {base[0], base[2], 3}};
  for (std::size_t next = 4; next < points.size(); ++next) {
    std::vector<SphereFace> kept;
    // Sides of the faces that the next point sees from outside.
    std::set<std::array<std::size_t, 2>> sides;
    for (const SphereFace& f : faces) {
      const int side = side_of(points[f[0]], points[f[1]], points[f[2]], points[next]);
      if (side == 0) return std::nullopt;
      if (side > 0) {
        kept.push_back(f);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) sides.insert({f[k], f[(k + 1) % 3]});
    }
    for (const auto& [a, b] : sides) {
      if (!sides.contains({b, a})) kept.push_back({a, b, next});
    }
    faces = std::move(kept);
  }
  return faces;
}

std::vector<SphereFace> hull_of_directions(const std::vector<Vector3d>& directions) {
  // If four points are in one plane, tries again with other displacements.
  for (std::uint64_t round = 0;; ++round) {
    std::vector<IntegerPoint> points;
    for (std::size_t i = 0; i < directions.size(); ++i)
      points.push_back(integer_point(directions[i], i, round));
    if (const auto faces = hull_of(points)) return *faces;
  }
}

// Positive if the middle of the sphere is on the inner side of the face.
double outwards(const std::vector<Vector3d>& d, const SphereFace& f) {
  return d[f[0]].dot(d[f[1]].cross(d[f[2]]));
}

// The normal of the plane through the first direction and the one that is nearest to a right angle
// with it. If all directions are in one plane, it is that plane's normal.
Vector3d normal_of(const std::vector<Vector3d>& directions) {
  Vector3d normal = Vector3d::Zero();
  for (const Vector3d& d : directions) {
    const Vector3d other = directions[0].cross(d);
    if (other.norm() > normal.norm()) normal = other;
  }
  return normal.normalized();
}

// Three directions whose determinant is at most this make no triangle: their views are on one great
// circle, up to the displacements in integer_point().
constexpr double kFlat = 0x1p-18;

// Whether the directions are on one great circle. The tolerance is kFlat, so that no three of them
// make a triangle.
bool is_circle(const std::vector<Vector3d>& directions) {
  const Vector3d normal = normal_of(directions);
  return std::ranges::all_of(directions,
                             [&](const Vector3d& d) { return std::abs(normal.dot(d)) < kFlat; });
}

}  // namespace

ViewSphere::ViewSphere(std::span<const Vector3d> directions)
    : directions_(directions.begin(), directions.end()) {
  std::vector<std::size_t> number;  // the number of each view in `distinct`
  std::vector<Vector3d> distinct;
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const bool is_new = std::ranges::none_of(
        distinct, [&](const Vector3d& other) { return (other - directions_[i]).norm() < 0x1p-20; });
    if (!is_new) continue;
    number.push_back(i);
    distinct.push_back(directions_[i]);
  }
  corners_ = number;
  std::vector<SphereFace> faces;
  if (distinct.size() == 2) border_.push_back({number[0], number[1]});
  if (distinct.size() > 2 && is_circle(distinct)) {
    join_circle(distinct, number);
  } else if (distinct.size() == 3) {
    faces = {{0, 1, 2}, {0, 2, 1}};
  } else if (distinct.size() > 3) {
    faces = hull_of_directions(distinct);
  }
  std::set<std::array<std::size_t, 2>> sides;
  for (const SphereFace& f : faces) {
    if (!(outwards(distinct, f) > kFlat)) continue;
    triangles_.push_back({number[f[0]], number[f[1]], number[f[2]]});
    for (std::size_t k = 0; k < 3; ++k) sides.insert({number[f[k]], number[f[(k + 1) % 3]]});
  }
  for (const auto& [a, b] : sides) {
    if (!sides.contains({b, a})) border_.push_back({a, b});
  }
}

void ViewSphere::join_circle(const std::vector<Vector3d>& distinct,
                             const std::vector<std::size_t>& number) {
  const Vector3d normal = normal_of(distinct);
  const Vector3d beside = normal.cross(distinct[0]);
  std::vector<std::pair<double, std::size_t>> around;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    around.emplace_back(arctan2(distinct[i].dot(beside), distinct[i].dot(distinct[0])), i);
  std::ranges::sort(around);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::size_t a = around[i].second, b = around[(i + 1) % around.size()].second;
    // Between two neighbouring views that are half a turn or more apart there is no cone.
    if (distinct[a].cross(distinct[b]).dot(normal) > 0) border_.push_back({number[a], number[b]});
  }
}

ViewWeights ViewSphere::weights(const Vector3d& direction) const {
  for (const auto& t : triangles_) {
    Matrix3d basis;
    for (int k = 0; k < 3; ++k) basis.col(k) = directions_[t[std::size_t(k)]];
    const Vector3d w = basis.inverse() * direction;
    // A direction on the common side of two triangles is in both of them. The tolerance makes sure
    // that in spite of rounding it is in at least one.
    if (!(w.minCoeff() >= -1e-12)) continue;
    const Vector3d share = w.cwiseMax(0.0) / w.cwiseMax(0.0).sum();
    ViewWeights weights;
    for (int k = 0; k < 3; ++k) {
      if (share[k] > 0) weights.push_back({t[std::size_t(k)], share[k]});
    }
    return weights;
  }
  // The direction is outside of the cone that all views span. The nearest direction in the cone is
  // on its border: in the plane of two views, between them, or at one of them.
  ViewWeights best;
  double most = -2;
  for (const auto& [a, b] : border_) {
    Eigen::Matrix<double, 3, 2> basis;
    basis << directions_[a], directions_[b];
    const Eigen::Matrix2d gram = basis.transpose() * basis;
    const Vector2d w = gram.inverse() * (basis.transpose() * direction);
    if (!(w.minCoeff() >= 0) || !(w.sum() > 0)) continue;
    const Vector3d nearest = (basis * w).normalized();
    if (!(nearest.dot(direction) > most)) continue;
    most = nearest.dot(direction);
    best = {{a, w[0] / w.sum()}, {b, w[1] / w.sum()}};
    std::erase_if(best, [](const ViewWeight& each) { return !(each.weight > 0); });
  }
  for (const std::size_t view : corners_) {
    const double near = directions_[view].dot(direction);
    if (near > most) {
      most = near;
      best = {{view, 1}};
    }
  }
  return best;
}

}  // namespace glassbox::views
