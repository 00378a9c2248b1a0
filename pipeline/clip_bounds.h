// Running error bounds of a clipped polygon: the bounds after one plane are the input for the next
// plane.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glassbox/pipeline/clip.h>

namespace glassbox {

struct ClipVertexBound {
  glm::dvec4 position{0};  // clip units
  glm::dvec3 weights{0};
};

// The bound of the error of signed_distance() for a position with the error bounds dx, dy, dz, dw:
// |a| dx + |b| dy + |c| dz + |d| dw. The sum adds next to nothing: it has the exact sign and is
// correct to a few ulps of double.
double distance_bound(const ClipPlane& plane, const glm::dvec4& position_bound);

// The bound of the error of the crossing X of the plane and the edge from p to q. X = p + s (q -
// p), s = dp/(dp - dq), where dp and dq are the distances of p and q from the plane. Exact
// arithmetic on the exact ends p* and q* gives X* = (1 - s*) p* + s* q*, so
//   |X - X*| <= (1 - s + ds) |p - p*| + (s + ds) |q - q*| + ds |q - p| + u |X|,
//   ds = (|dq| b(dp) + |dp| b(dq)) / (D (D - b(dp) - b(dq))),   D = |dp - dq|,
//   where b() is the bound of a distance's error and u the unit roundoff.
// If the plane determines one of x, y, z from w (clip.h), the error of that coordinate comes from w
// alone. The bound is infinite where D is not larger than b(dp) + b(dq): the edge may be parallel
// to the plane.
ClipVertexBound crossing_bound(const ClipPlane& plane, const ClipVertex& p,
                               const ClipVertexBound& p_bound, double p_distance,
                               const ClipVertex& q, const ClipVertexBound& q_bound,
                               double q_distance, const ClipVertex& crossing);

}  // namespace glassbox
