// Running error bounds of a fragment (SPEC C, bounds 4, 5 and 8): how far its computed numbers may
// be from the result of exact arithmetic on the snapped triangle. Edge functions, areas and
// barycentric coordinates as integers have no error (bound 4 is 0). Only what is computed from them
// in float has an error, and what the vertices already had.
//
// Every bound is absolute, in the unit of its number. interpolate.h derives the local part;
// docs/trace.md lists them all.
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
  // The bound of 1 / inverse_w, the distance along the gaze: w^2 delta(1/w) to first order.
  double distance = 0;
};

FragmentBounds fragment_bounds(const TriangleSetup& setup, const Fragment& fragment,
                               const SetupBounds& vertices);

// The bound of an attribute at the fragment. `values` are its values at the vertices in the order
// of the setup, `bounds` their own bounds.
double attribute_bound(const std::array<float, 3>& values, const std::array<double, 3>& bounds,
                       const TriangleSetup& setup, const Fragment& fragment,
                       const SetupBounds& vertices);

// Converts an error of the depth, `depth_bound`, to an error of the distance along the gaze at
// `distance`: z^2 (f - n)/(f n) times the depth's error, for a perspective view with planes at n
// and f (f may be infinite).
double distance_of_depth(double distance, double near, double far, double depth_bound);

// The same error as a share of the distance. `first_order` is the result of distance_of_depth()
// divided by the distance. Since 1/z is linear in the depth, the same depth error means a larger
// error of the distance behind the point than in front of it, so a share s becomes s/(1 - s).
// Infinite where s is 1 or more.
double share_of_distance(double first_order);

// Bounds the error of twice the signed area on the screen, in square pixels: the difference between
// the snapped triangle and the exact one if no coordinate moved by more than `displacement` pixels,
// s. It is 2 s (|u|_1 + |v|_1) + 8 s^2, where u and v are two of the triangle's edges.
double area_bound(const std::array<ScreenVertex, 3>& vertices, double displacement);

}  // namespace glassbox
