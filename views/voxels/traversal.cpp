#include "views/voxels/traversal.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace glassbox::views {

namespace {

// The difference x - c of a point x of the box and a camera c that is smallest along the direction.
Vector3d least_along(const Vector3d& direction, const std::vector<Vector3d>& cameras,
                     const Vector3d& low, const Vector3d& high) {
  const Vector3d corner = (direction.array() > 0).select(low, high);
  const auto& camera =
      *std::ranges::max_element(cameras, {}, [&](const Vector3d& c) { return direction.dot(c); });
  return corner - camera;
}

// Gilbert's algorithm (1966): finds the point nearest to the origin in the convex hull of all
// differences x - c of a point x of the box and a camera c. If that point is not the origin, it is
// a direction along which the box is beyond all cameras.
std::optional<Vector3d> separating_direction(const std::vector<Vector3d>& cameras,
                                             const Vector3d& low, const Vector3d& high) {
  Vector3d nearest = (low + high) / 2 - cameras.front();
  for (int step = 0; step < kDirectionSteps; ++step) {
    const Vector3d least = least_along(nearest, cameras, low, high);
    if (nearest.dot(least) > 0) return nearest.normalized();
    const Vector3d way = least - nearest;
    const double along = -nearest.dot(way) / way.squaredNorm();
    if (!(along > 0)) return std::nullopt;
    nearest += std::min(along, 1.0) * way;
    if (!(nearest.squaredNorm() > 0)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name_of(TraversalKind kind) {
  switch (kind) {
    case TraversalKind::kOctant:
      return "octant";
    case TraversalKind::kQuadrant:
      return "quadrant";
    case TraversalKind::kHalfSpace:
      return "half-space";
    case TraversalKind::kOblique:
      return "oblique";
    case TraversalKind::kEmbedded:
      return "embedded";
    case TraversalKind::kSurrounded:
      break;
  }
  return "surrounded";
}

Traversal classify(const std::vector<Vector3d>& cameras, const Vector3d& low,
                   const Vector3d& high) {
  Traversal traversal;
  int orders = 0;
  double widest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double least = INFINITY, greatest = -INFINITY;
    for (const Vector3d& camera : cameras) {
      least = std::min(least, camera[axis]);
      greatest = std::max(greatest, camera[axis]);
    }
    const double below = low[axis] - greatest, above = least - high[axis];
    if (!(below > 0) && !(above > 0)) continue;
    traversal.away[std::size_t(axis)] = below > 0 ? 1 : -1;
    ++orders;
    if (std::max(below, above) <= widest) continue;
    widest = std::max(below, above);
    traversal.direction = Vector3d::Unit(axis) * (below > 0 ? 1 : -1);
  }
  if (orders > 0) {
    constexpr TraversalKind kKinds[] = {TraversalKind::kHalfSpace, TraversalKind::kQuadrant,
                                        TraversalKind::kOctant};
    traversal.kind = kKinds[orders - 1];
    return traversal;
  }
  traversal.direction = separating_direction(cameras, low, high);
  if (traversal.direction) {
    traversal.kind = TraversalKind::kOblique;
    return traversal;
  }
  const bool all_inside = std::ranges::all_of(cameras, [&](const Vector3d& camera) {
    return (camera.array() >= low.array()).all() && (camera.array() <= high.array()).all();
  });
  if (all_inside) traversal.kind = TraversalKind::kEmbedded;
  return traversal;
}

Matrix3d axes_along(const Vector3d& direction) {
  // The world axis that is nearest to the direction is turned into it.
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const Vector3d from = Vector3d::Unit(axis) * (direction[axis] > 0 ? 1 : -1);
  // The quaternion that turns `from` into `to`, a unit vector. With the angle a between them and
  // the axis n it is cos(a/2) and sin(a/2) n, computed from cos a and the cross product sin(a) n.
  // Eigen's FromTwoVectors computes the same, but also contains a solver for opposite vectors;
  // these two vectors are at most 55 degrees apart.
  const Vector3d to = direction.normalized();
  const double twice_cosine = std::sqrt((1 + to.dot(from)) * 2);  // 2 cos(a/2)
  const Vector3d along = from.cross(to) * (1 / twice_cosine);
  const Matrix3d turn =
      Eigen::Quaterniond(twice_cosine * 0.5, along.x(), along.y(), along.z()).toRotationMatrix();
  Matrix3d axes;
  axes.col(2) = turn * from;
  axes.col(0) = turn * Vector3d::Unit((axis + 1) % 3);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace glassbox::views
