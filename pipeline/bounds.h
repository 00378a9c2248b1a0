// Running error bounds of the geometric stages (docs/references.md, bounds 1 to 3): upper bounds of
// the difference between a computed number and the exact result for the same input. Every bound is
// absolute, in the unit of its number, and includes the bounds of the numbers that it was computed
// from. An inspector prints the bound beside the number.
//
// The bounds hold for the stages' float operations in any order of summation, with or without
// gradual underflow to subnormal numbers, as long as nothing overflows (then they are infinite or
// NaN). The bounds themselves are computed in double and rounded up by 2^-40 of their size, which
// covers their own rounding errors.
#pragma once

#include <glm/mat4x4.hpp>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// ---- 1. transform ----

// The vector |M| |x|, from the absolute values of all entries. The rounding error of M x is at most
// gamma_n times this, row by row (n is the number of products in a row).
glm::dvec4 magnitude(const glm::dmat4& m, const glm::dvec4& x);

// The bound of |computed - exact| of M x, per row: gamma_n |M||x| + |M| dx + dM (|x| + dx), where n
// is the number of products in the row that are not zero, and dx and dM bound the errors of the
// given x and M (`x_bound`, `m_bound`). A row with a single product, such as the w of most
// projections, gets its actual rounding error instead, which is zero where the factor is a power of
// two.
glm::dvec4 transform_bound(const glm::mat4& m, const glm::vec4& x,
                           const glm::dvec4& x_bound = glm::dvec4(0),
                           const glm::dmat4& m_bound = glm::dmat4(0));

// How much round_to_float changes each entry m of a matrix: at most u |m| (u is the unit roundoff,
// 2^-24), or half the smallest subnormal number.
glm::dmat4 rounding_bound(const glm::dmat4& m);

// The bound of |computed - exact| of the product A B of matrices in double. It includes the effects
// of the errors of A and B, bounded by `a_bound` and `b_bound`.
glm::dmat4 product_bound(const glm::dmat4& a, const glm::dmat4& b,
                         const glm::dmat4& a_bound = glm::dmat4(0),
                         const glm::dmat4& b_bound = glm::dmat4(0));

// ---- 2. divide ----

struct DivideBound {
  glm::dvec3 position{0};  // of x/w, y/w, z/w
  double inverse_w = 0;
};

// The bound of the error of x/w (also for y and z): (dx + |x/w| dw)/(|w| - dw) + u |x/w|, where dx
// and dw bound the errors of x and w and u is the unit roundoff. It is infinite where w may be
// zero. Where w is 1, dividing adds no rounding error.
DivideBound divide_bound(const Point<Clip>& clip, const glm::dvec4& clip_bound);

// The absolute change of x/w, y/w, z/w for a relative change of 1 in the numbers that clip x, y, z
// and w were computed from, a matrix M and a vector v. For x it is (|m_x||v| + |x/w| |m_w||v|)/|w|,
// where m_x and m_w are rows of M; `clip_magnitude` is |M||v|. It is infinite at w = 0.
glm::dvec3 divide_condition(const Point<Clip>& clip, const glm::dvec4& clip_magnitude);

// ---- 3. screen ----

// The bound of the screen position's error in pixels: (W/2) dx + 2 u (|W/2 x| + |centre|), where W
// is the viewport's width (or height), dx the bound of NDC x and u the unit roundoff, plus the
// rounding errors of half the size and of the centre in float. The z component is the bound of NDC
// z, because to_screen does not change z.
glm::dvec3 screen_bound(const Point<Ndc>& ndc, const glm::dvec3& ndc_bound,
                        const Viewport& viewport);

// The snap to 1/256 pixel, halves rounded up (raster/snap.h), changes a coordinate by up to 1/512
// pixel. It is stable if every number within `bound` of `pixels` is snapped to the same place.
struct SnapStability {
  double snapped = 0;      // pixels, a multiple of 1/256
  double to_boundary = 0;  // distance to the nearest place where the snap jumps, pixels
  bool stable = false;
};
SnapStability snap_stability(float pixels, double bound);

}  // namespace glassbox
