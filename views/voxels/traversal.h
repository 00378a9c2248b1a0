// Orders in which voxels may be visited so that what hides comes before what it hides (S1-15, S1-30, S1-38).
//
// A point P hides Q from a camera C if it lies on the segment from C to Q. If a plane has all cameras on its one side and all of the
// scene on the other, P is nearer to it than Q: layers parallel to it, away from the cameras, are such an order (Seitz and Dyer 1997).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "views/voxels/grid.h"

namespace glassbox::views {

enum class TraversalKind {
  kOctant,     // beyond a face of the box along all three axes: each of them is an order
  kQuadrant,   // along two
  kHalfSpace,  // along one
  kOblique,    // along none of them, but along another direction
  kEmbedded,   // all cameras are inside the box: outwards in shells, if nothing stands between them
  kSurrounded,  // no order: some of what is in the box is between cameras
};
std::string_view name_of(TraversalKind kind);  // "half-space"

struct Traversal {
  TraversalKind kind = TraversalKind::kSurrounded;
  // For each axis: 1 where the coordinate grows away from all cameras, -1 where it falls, 0 where neither.
  std::array<int, 3> away{0, 0, 0};
  // The direction of kOblique and of the three before it, unit length, in the coordinates that were asked about: for each camera c
  // and each point x of the box, direction . (x - c) > 0.
  std::optional<Vector3d> direction;
};

// Of cameras and of a box from `low` to `high`, all in the same coordinates. What is called an order is one: the plane is checked
// against every camera and every corner. The search for an oblique one ends after kDirectionSteps steps: a gap that is thin beside the
// whole may be taken for none, which is an answer on the safe side (C-90).
inline constexpr int kDirectionSteps = 20000;
Traversal classify(const std::vector<Vector3d>& cameras, const Vector3d& low, const Vector3d& high);

// Axes for a grid whose layers along z lead along `direction`: of the world's, turned by the shortest way.
Matrix3d axes_along(const Vector3d& direction);

}  // namespace glassbox::views
