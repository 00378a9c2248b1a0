// Running error bounds of the geometric stages (SPEC C, generic bounds 1 to 3): how far a computed number may lie from what
// exact arithmetic makes of the same input. Every bound is an absolute one, in the unit of its number, and takes over the
// bounds of the numbers that went in; an inspector prints it beside the number.
//
// They hold for the stages' float operations in any order of summation, with or without gradual underflow to subnormal
// numbers, as long as nothing overflows (then they are infinite or NaN). The bounds themselves are computed in double and
// rounded up by 2^-40 of their size, which covers their own roundings.
#pragma once

#include <glm/mat4x4.hpp>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// ---- 1. transform ----

// |M||x|, row by row: what the rounding of M x is relative to.
glm::dvec4 magnitude(const glm::dmat4& m, const glm::dvec4& x);

// |computed - exact| of M x, per row: gamma_n |M||x| + |M| dx + dM (|x| + dx), n the number of products in the row that are
// not zero. A row with a single product, such as the w of most projections, is charged with its actual rounding, which is
// none where the factor is a power of two. `x_bound` and `m_bound`: how far the given x and M are from what is meant.
glm::dvec4 transform_bound(const glm::mat4& m, const glm::vec4& x,
                           const glm::dvec4& x_bound = glm::dvec4(0),
                           const glm::dmat4& m_bound = glm::dmat4(0));

// How far round_to_float moves the entries of a matrix: at most u |M|, or half the smallest subnormal.
glm::dmat4 rounding_bound(const glm::dmat4& m);

// |computed - exact| of the product A B of matrices in double, their own bounds taken over.
glm::dmat4 product_bound(const glm::dmat4& a, const glm::dmat4& b,
                         const glm::dmat4& a_bound = glm::dmat4(0),
                         const glm::dmat4& b_bound = glm::dmat4(0));

// ---- 2. divide ----

struct DivideBound {
  glm::dvec3 position{0};  // of x/w, y/w, z/w
  double inverse_w = 0;
};

// (dx + |x/w| dw)/(|w| - dw) + u |x/w|; infinite where w may be zero. Nothing is lost where w is 1.
DivideBound divide_bound(const Point<Clip>& clip, const glm::dvec4& clip_bound);

// How a relative change of the numbers that made clip x, y, z and w is magnified in x/w, y/w, z/w, absolutely:
// (|m_x||v| + |x/w| |m_w||v|)/|w|, given the magnitudes |M||v| of the four. Infinite at w = 0.
glm::dvec3 divide_condition(const Point<Clip>& clip, const glm::dvec4& clip_magnitude);

// ---- 3. screen ----

// (W/2) dx + 2 u (|W/2 x| + |centre|) pixels, and what the viewport's own half size and centre lost in float. z: that of NDC,
// as to_screen leaves it alone.
glm::dvec3 screen_bound(const Point<Ndc>& ndc, const glm::dvec3& ndc_bound,
                        const Viewport& viewport);

// The snap to 1/256 pixel, halves up (raster/snap.h), adds up to 1/512 pixel. It is stable where no number within the
// bound would have gone elsewhere.
struct SnapStability {
  double snapped = 0;      // pixels, a multiple of 1/256
  double to_boundary = 0;  // pixels from the nearest place where the snap jumps
  bool stable = false;
};
SnapStability snap_stability(float pixels, double bound);

}  // namespace glassbox
