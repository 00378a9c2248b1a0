// Orders in which voxels may be visited so that an occluder comes before what it hides (S1-15,
// S1-30, S1-38).
//
// A point P hides Q from a camera C if it is on the segment from C to Q. If a plane has all cameras
// on one side and the whole scene on the other, P is nearer to the plane than Q. So layers parallel
// to the plane, visited away from the cameras, are such an order (Seitz and Dyer 1997).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "views/voxels/grid.h"

namespace glassbox::views {

enum class TraversalKind {
  // The cameras are beyond a face of the box along all three axes; each axis gives an order.
  kOctant,
  kQuadrant,   // the cameras are beyond a face along two axes
  kHalfSpace,  // the cameras are beyond a face along one axis
  kOblique,    // the cameras are beyond the box along another direction, but along no axis
  // All cameras are inside the box: shells outwards, if no part of the scene is between them.
  kEmbedded,
  kSurrounded,  // no order: a part of the box is between cameras
};
std::string_view name_of(TraversalKind kind);  // for example "half-space"

struct Traversal {
  TraversalKind kind = TraversalKind::kSurrounded;
  // For each axis: 1 if the coordinate grows away from all cameras, -1 if it falls, 0 if neither.
  std::array<int, 3> away{0, 0, 0};
  // For all kinds but kEmbedded and kSurrounded: a direction away from the cameras, of unit length,
  // in the coordinates of classify()'s arguments. For each camera c and each point x of the box,
  // direction . (x - c) > 0.
  std::optional<Vector3d> direction;
};

// Classifies cameras and a box from `low` to `high`, all in the same coordinates. An order that is
// returned is always correct: its plane is checked against every camera and every corner. The
// search for an oblique direction ends after kDirectionSteps steps, so it may miss a gap between
// the cameras and the box that is very thin compared with both. The answer is then kSurrounded,
// which is safe (C-90).
inline constexpr int kDirectionSteps = 20000;
Traversal classify(const std::vector<Vector3d>& cameras, const Vector3d& low, const Vector3d& high);

// Axes for a grid whose layers along z follow `direction`: the world's axes, turned by the smallest
// angle.
Matrix3d axes_along(const Vector3d& direction);

}  // namespace glassbox::views
