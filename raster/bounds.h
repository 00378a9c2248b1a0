// Running error bounds of a fragment (SPEC C, bounds 4, 5 and 8): how far its computed numbers may
// be from the result of exact arithmetic on the snapped triangle. Edge functions and areas are
// integers and have no error (bound 4 is 0). Errors come from the float computations with them, and
// from the errors of the vertices' numbers.
//
// Every bound is absolute, in the unit of its number. formulas/interpolate.h derives the errors of
// the float computations; docs/trace.md lists all bounds.
#pragma once

#include <array>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// Bounds on the errors of the numbers of a triangle's vertices, in the order of the setup.
struct SetupBounds {
  std::array<double, 3> depth{};
  std::array<double, 3> inverse_w{};
};

struct FragmentBounds {
  std::array<double, 3> lambda{};
  double depth = 0;
  double inverse_w = 0;
  std::array<double, 3> weights{};
  // The bound of the error of 1 / inverse_w, the distance along the gaze: to first order, w^2 times
  // the bound of inverse_w.
  double distance = 0;
};

FragmentBounds fragment_bounds(const TriangleSetup& setup, const Fragment& fragment,
                               const SetupBounds& vertices);

// The bound of an attribute's error at the fragment. `values` are its values at the vertices in the
// order of the setup, `bounds` the bounds of their errors.
double attribute_bound(const std::array<float, 3>& values, const std::array<double, 3>& bounds,
                       const TriangleSetup& setup, const Fragment& fragment,
                       const SetupBounds& vertices);

// Converts an error of the depth, `depth_bound`, to an error of the distance along the gaze at
// `distance`: z^2 (f - n)/(f n) times the depth's error, for the distance z in a perspective view
// with the near and far planes n and f (f may be infinite).
double distance_of_depth(double distance, double near, double far, double depth_bound);

// The error of the distance as a fraction of the distance, from `first_order`: the result of
// distance_of_depth() divided by the distance. 1/z is linear in the depth, so an error of the depth
// means a larger error of the distance behind the point than in front of it: the fraction s becomes
// s/(1 - s). The result is infinite where s is 1 or more.
double share_of_distance(double first_order);

// Bounds the error of twice the signed area on the screen, in square pixels: the difference between
// the snapped triangle and the exact one if snapping moved no coordinate by more than s =
// `displacement` pixels. It is 2 s (|u|_1 + |v|_1) + 8 s^2, where u and v are two of the triangle's
// edges and |u|_1 is the sum of u's absolute coordinates.
double area_bound(const std::array<ScreenVertex, 3>& vertices, double displacement);

}  // namespace glassbox
