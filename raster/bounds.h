// Running error bounds of a fragment (SPEC C, generic bounds 4, 5 and 8): how far its numbers may lie from what exact
// arithmetic makes of the snapped triangle. Edge functions, areas and barycentric coordinates as integers have no error (bound
// 4 is 0): only what is computed from them in float does, and what the vertices bring with them.
//
// Every bound is absolute, in the unit of its number. interpolate.h derives the local part; docs/trace.md has the list.
#pragma once

#include <array>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// How far the numbers of a triangle's vertices may lie from what is meant, in the order of the setup.
struct SetupBounds {
  std::array<double, 3> depth{};
  std::array<double, 3> inverse_w{};
};

struct FragmentBounds {
  std::array<double, 3> lambda{};
  double depth = 0;
  double inverse_w = 0;
  std::array<double, 3> weights{};
  // Of 1 / inverse_w, the distance along the gaze: w^2 delta(1/w) to first order.
  double distance = 0;
};

FragmentBounds fragment_bounds(const TriangleSetup& setup, const Fragment& fragment,
                               const SetupBounds& vertices);

// Of an attribute at the fragment: `values` at the vertices in the order of the setup, and their own bounds.
double attribute_bound(const std::array<float, 3>& values, const std::array<double, 3>& bounds,
                       const TriangleSetup& setup, const Fragment& fragment,
                       const SetupBounds& vertices);

// Distance along the gaze that a change of the depth by `depth_bound` stands for, `distance` away: z^2 (f - n)/(f n) times
// it, for a perspective with planes at n and f (which may be infinite).
double distance_of_depth(double distance, double near, double far, double depth_bound);

// The same as a share of the distance, given `first_order`, that of above: 1/z is linear in the depth, so what lies behind by a
// depth's error lies further behind than what lies before by it, and s becomes s/(1 - s). Infinite where that may be beyond all.
double share_of_distance(double first_order);

// Twice the signed area on the screen, in square pixels: how far that of the snapped triangle may lie from the exact one's
// if no coordinate has been moved by more than `displacement` pixels. 2 s (|u|_1 + |v|_1) + 8 s^2, u and v two of its edges.
double area_bound(const std::array<ScreenVertex, 3>& vertices, double displacement);

}  // namespace glassbox
