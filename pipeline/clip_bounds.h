// Running error bounds of the polygon that clipping leaves, passed on from plane to plane.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glassbox/pipeline/clip.h>

namespace glassbox {

struct ClipVertexBound {
  glm::dvec4 position{0};  // clip units
  glm::dvec3 weights{0};
};

// The bound of the error of the distance from the plane: |a| dx + |b| dy + |c| dz + |d| dw. The sum
// itself has the exact sign and is correct to a few ulps of double.
double distance_bound(const ClipPlane& plane, const glm::dvec4& position_bound);

// The bound of the crossing's error. X = p + s (q - p), s = dp/(dp - dq). Exact arithmetic on the
// exact ends gives X* = (1 - s*) p* + s* q*, so
//   |X - X*| <= (1 - s + ds) |p - p*| + (s + ds) |q - q*| + ds |q - p| + u |X|,
//   ds = (|dq| b(dp) + |dp| b(dq)) / (D (D - b(dp) - b(dq))),   D = |dp - dq|,
//   b() being the bounds of the distances.
// The plane's own coordinate follows from the others (clip.h): where that is one coordinate, its
// error comes from w alone. Infinite where D is within its own bound: the edge may be parallel to
// the plane.
ClipVertexBound crossing_bound(const ClipPlane& plane, const ClipVertex& p,
                               const ClipVertexBound& p_bound, double p_distance,
                               const ClipVertex& q, const ClipVertexBound& q_bound,
                               double q_distance, const ClipVertex& crossing);

}  // namespace glassbox
