// From object space to the screen in the float stages and back again (S3-03): how much of a point's place the floats
// have lost on the way, and how much they can lose.
#pragma once

#include <optional>

#include <glm/mat4x4.hpp>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// Clip from object in double, and how far each entry may be from the exact product of the matrices that it is made of.
struct WayThere {
  glm::dmat4 clip_from_object{1};
  glm::dmat4 bound{0};
};

struct RoundTrip {
  Point<Screen> screen;          // in float: pixels, and the depth of NDC
  Point<Object, double> object;  // where these three numbers lead back to
  glm::dvec3 error{0};           // how far that is from the point, coordinate by coordinate
  glm::dvec3 bound{0};  // of the error; infinite where the three numbers do not tell the place
  bool is_bounded() const;
};

// Divides the point's clip coordinates by w and puts them on the screen as the stages do, then goes back in double, so that
// what is seen is what the floats have lost. `clip_bound`: how far `clip` may be from the exact matrices' product with
// `object`, which counts as exact. Nothing where w is not positive or a coordinate is not finite: such a point has no
// place on the screen.
//
// The way back asks nothing of the projection. With n the NDC that the screen stands for, the point p solves
//   (row_i(M) - n_i row_w(M)) . (p, 1) = 0,   i = x, y, z,   M = clip_from_object,
// three linear equations A p = b. The bound: the true p satisfies the same equations for the exact n* and M*, so for the p'
// that was found, with r = A p' - b what is left of its equations, |n - n*| <= e and |M - M*| <= dM,
//   |p' - p| <= |A^-1| (|r| + e |w| + (dM_i + |n_i| dM_w) (|p|, 1)),
// where e is the bound of the screen turned back into NDC, w the exact one (|clip.w| and its bound), and |A^-1| is enclosed
// by an approximate inverse N: |A^-1| q <= |N| q + max(|N| q) c/(1 - c), c the largest row sum of |I - N A| (Rump 1999). The
// roundings of double are added to r and c.
std::optional<RoundTrip> round_trip(const Point<Object>& object, const Point<Clip>& clip,
                                    const glm::dvec4& clip_bound, const WayThere& way,
                                    const Viewport& viewport);

}  // namespace glassbox
