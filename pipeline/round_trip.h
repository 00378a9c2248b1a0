// From object space to the screen in the float stages and back again (S3-03): how much of a point's
// position is lost to float rounding on the way, and how much can be lost at most.
#pragma once

#include <optional>

#include <glm/mat4x4.hpp>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// The matrix from object to clip space in double, and a bound of each entry's distance from the
// exact product of its factors.
struct ForwardTransform {
  glm::dmat4 clip_from_object{1};
  glm::dmat4 bound{0};
};

struct RoundTrip {
  Point<Screen> screen;          // in float: pixels, and the depth of NDC
  Point<Object, double> object;  // the point that this x, y and depth lead back to
  glm::dvec3 error{0};           // difference of `object` from the given point
  // Upper bound of the error; infinite where the screen position and depth do not determine a
  // point.
  glm::dvec3 bound{0};
  bool is_bounded() const;
};

// Divides the point's clip coordinates by w and maps them to the screen as the stages do, then goes
// back in double, so that the error is only what the float stages have lost. `clip_bound`: the
// bound of the distance of `clip` from the product of the exact matrices and `object`, which is
// taken as exact. Returns nothing where w is not positive or a coordinate is not finite: such a
// point has no position on the screen.
//
// The way back works for any projection. With n the NDC that the screen position corresponds to,
// the point p solves
//   (row_i(M) - n_i row_w(M)) . (p, 1) = 0,   i = x, y, z,   M = clip_from_object,
// three linear equations A p = b. The bound: the true p satisfies the same equations for the exact
// n* and M*. So for the p' that was found, with the residual r = A p' - b, |n - n*| <= e and |M -
// M*| <= dM,
//   |p' - p| <= |A^-1| (|r| + e |w| + (dM_i + |n_i| dM_w) (|p|, 1)),
// where e is the bound of the screen position converted back into NDC, w the exact one (|clip.w|
// and its bound), and |A^-1| is enclosed by an approximate inverse N: |A^-1| q <= |N| q + max(|N|
// q) c/(1 - c), with c the largest row sum of |I - N A| (Rump 1999). The rounding errors of double
// are added to r and c.
std::optional<RoundTrip> round_trip(const Point<Object>& object, const Point<Clip>& clip,
                                    const glm::dvec4& clip_bound, const ForwardTransform& forward,
                                    const Viewport& viewport);

}  // namespace glassbox
