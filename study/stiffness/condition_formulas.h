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

// The vertical size in pixels of one unit of length across the gaze, at distance 1; in parallel
// views at any distance.
double pixels_per_unit(const View& view);

// The error of the distance along the gaze that the error dd of the depth causes, as a fraction of
// the distance z. With the planes at n and f, the first-order fraction is s = z (f - n)/(f n) dd;
// returns s/(1 - s), which also bounds errors towards the far plane. dd is the sum of `ndc_bound`
// of the vertices, 8 u |depth| for interpolation (u is the unit roundoff, 2^-24), and half a step
// of the format (docs/references.md, bound 8).
double depth_share(const View& view, DepthFormat format, double depth, double distance,
                   double ndc_bound);

// How far a point moves on the screen, in pixels, if its object-space coordinates change by dp,
// half a unit in the last place. To first order, x moves by (W/2 (|M_x| + |x/w| |M_w|) dp)/(w -
// |M_w| dp), where W is the width of the viewport, and M_x and M_w are the matrix rows for x and w.
// The same holds for y; returns the larger one. `clip_from_object` is the exact matrix rounded to
// the nearest (C-13, C-14).
double half_ulp_on_screen(const Transform<Clip, Object>& clip_from_object,
                          const Point<Object>& position, const Viewport& viewport);

// L^2/(2 A) of a triangle on the screen, with the longest side L and the area A: this is the
// longest side divided by the height over it (docs/references.md, bound 5). Infinite if the
// triangle has no area.
double sliver_factor(const std::array<std::array<double, 2>, 3>& triangle);

// An upper bound for the error of a triangle's weights, as a fraction of an attribute's range, if
// each vertex has moved by at most `moved` pixels along x and along y. A point with the same
// weights then moves by at most d = sqrt(2) `moved`. A weight grows from 0 to 1 over a height h of
// the exact triangle, and the moved triangle's height is at least h - 2 d, hence the bound d/(h - 2
// d). Infinite if the triangle may have no height.
double sliver_share(const std::array<std::array<double, 2>, 3>& triangle, double moved);

// The sine of the angle between the gaze and `up` (C-01), and the number of pixels by which a
// corner of the picture moves if the entries of the rotation have errors of (8 + 4/sine) u each
// (pipeline/look_at.h; u is the unit roundoff of double). As an angle, the error is 3 times as
// large; in pixels it is multiplied by F (1 + (d/F)^2), where F is the focal length and d half the
// picture's diagonal, both in pixels. `gaze` and `up` may have any length.
struct UpAngle {
  double sine = 1;
  double pixels = 0;
};
UpAngle up_angle(const Vector<World, double>& gaze, const Vector<World, double>& up,
                 const View& view);

// Half a unit in the last place of a texture coordinate, in texels of a texture that is `size`
// texels wide or high (C-67).
double half_ulp_in_texels(float coordinate, int size);

}  // namespace glassbox::study
