// The formulas of a picture's condition numbers: each says how much an error is magnified, and
// gives the resulting bound. Lengths on the screen are in pixels. The values that count as exact
// are the same as in trace/bounds.h.
#pragma once

#include <array>
#include <optional>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/depth.h>

namespace glassbox::study {

// The number of pixels that one unit across the gaze, at distance 1, takes up vertically; in
// parallel views at any distance.
double pixels_per_unit(const View& view);

// The error of the distance along the gaze that the error of the depth causes, as a share of the
// distance z: s = z (f - n)/(f n) dd, and s/(1 - s) for the distance behind the point. Here dd is
// the sum of `ndc_bound` of the vertices, 8 u of the depth for its interpolation, and half a step
// of the format (bound 8).
double depth_share(const View& view, DepthFormat format, double depth, double distance,
                   double ndc_bound);

// How far a point moves on the screen if its object-space coordinates change by half a unit in the
// last place, to first order: (W/2 (|M_x| + |x/w| |M_w|) dp)/(w - |M_w| dp), and the same for y;
// returns the larger one. `clip_from_object` is the exact matrix rounded to the nearest (C-13,
// C-14).
double half_ulp_on_screen(const Transform<Clip, Object>& clip_from_object,
                          const Point<Object>& position, const Viewport& viewport);

// L^2/2A of a triangle on the screen: its longest side divided by its height (bound 5). Infinite if
// it has no area.
double sliver_factor(const std::array<std::array<double, 2>, 3>& triangle);

// An upper bound for the error of a triangle's weights, as a share of an attribute's range, if each
// vertex has moved by at most `moved` pixels along x and along y. A point with the same weights
// moves by at most d = sqrt 2 `moved`, and a weight grows from 0 to 1 over a height h of the exact
// triangle, hence d/(h - 2 d). Infinite if the triangle may have no height.
double sliver_share(const std::array<std::array<double, 2>, 3>& triangle, double moved);

// The sine of the angle between the gaze and `up` (C-01), and the number of pixels by which a
// corner of the picture moves if the entries of the rotation have errors of (8 + 4/sine) u each
// (pipeline/look_at.h). The pixels are 3 times that error as an angle, times F (1 + (d/F)^2), where
// F is the focal length and d half the picture's diagonal, both in pixels. `gaze` and `up` may have
// any length.
struct UpAngle {
  double sine = 1;
  double pixels = 0;
};
UpAngle up_angle(const Vector<World, double>& gaze, const Vector<World, double>& up,
                 const View& view);

// Half a unit in the last place of a texture coordinate, in texels of a side of `size` texels
// (C-67).
double half_ulp_in_texels(float coordinate, int size);

}  // namespace glassbox::study
