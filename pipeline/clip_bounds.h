// Running error bounds of the polygon that clipping leaves, handed on from plane to plane.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glassbox/pipeline/clip.h>

namespace glassbox {

struct ClipVertexBound {
  glm::dvec4 position{0};  // clip units
  glm::dvec3 weights{0};
};

// How far the distance from the plane may be off: |a| dx + |b| dy + |c| dz + |d| dw. The sum itself is exact in its sign, and right to a few
// ulps of double.
double distance_bound(const ClipPlane& plane, const glm::dvec4& position_bound);

// How far the crossing may be off: X = p + s (q - p), s = dp/(dp - dq). Exact arithmetic on exact ends gives X* = (1 - s*) p* + s* q*, so
//   |X - X*| <= (1 - s + ds) |p - p*| + (s + ds) |q - q*| + ds |q - p| + u |X|,
//   ds = (|dq| b(dp) + |dp| b(dq)) / (D (D - b(dp) - b(dq))),   D = |dp - dq|, b() the bounds of the distances.
// The plane's own coordinate follows from the others (clip.h): where that is one coordinate, it inherits from w alone.
// Infinite where D is within its own bound: the edge may run along the plane.
ClipVertexBound crossing_bound(const ClipPlane& plane, const ClipVertex& p,
                               const ClipVertexBound& p_bound, double p_distance,
                               const ClipVertex& q, const ClipVertexBound& q_bound,
                               double q_distance, const ClipVertex& crossing);

}  // namespace glassbox
