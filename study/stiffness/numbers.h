// The condition numbers of a picture, one formula each: what decides how much of an error is magnified, and the bound that
// follows. Lengths on the screen are in pixels; what is exact is what trace/bounds.h takes for exact.
#pragma once

#include <array>
#include <optional>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/depth.h>

namespace glassbox::study {

// Pixels that a unit across the gaze takes up in a distance of 1, vertically; of parallel views anywhere.
double pixels_per_unit(const View& view);

// C bound 8: distance along the gaze that the depth's error stands for, as a share of the distance z: s = z (f - n)/(f n) dd, and
// s/(1 - s) behind it, where dd is `ndc_bound` of the vertices, 8 u of the depth for interpolating it, and half a step of the format.
double depth_share(const View& view, DepthFormat format, double depth, double distance,
                   double ndc_bound);

// C-13, C-14: how far half a unit in the last place of the coordinates as modelled moves their place on the screen, to first order
// in it: (W/2 (|M_x| + |x/w| |M_w|) dp)/(w - |M_w| dp), likewise y; the larger one. `clip_from_object` is the exact one's nearest.
double half_ulp_on_screen(const Transform<Clip, Object>& clip_from_object,
                          const Point<Object>& position, const Viewport& viewport);

// C bound 5: L^2/2A of a triangle on the screen, its longest side over its height. Infinite where it has no area.
double sliver_factor(const std::array<std::array<double, 2>, 3>& triangle);

// How much of an attribute's range a triangle's weights may be off if each vertex has been moved by no more than `moved` pixels
// along x and along y. A point with the same weights moves by d = sqrt 2 `moved` at most, and a weight grows from 0 to 1 over a height
// of the exact triangle: d/(h - 2 d). Infinite where the triangle may have no height.
double sliver_share(const std::array<std::array<double, 2>, 3>& triangle, double moved);

// C-01: the sine of the angle between the gaze and `up`, and by how many pixels a corner of the picture moves if the entries of the
// rotation are off by (8 + 4/sine) u each (pipeline/look_at.h): 3 of that as an angle, times F (1 + (d/F)^2), F the focal length
// and d half the picture's diagonal in pixels. `gaze` and `up` of any length.
struct UpAngle {
  double sine = 1;
  double pixels = 0;
};
UpAngle up_angle(const Vector<World, double>& gaze, const Vector<World, double>& up,
                 const View& view);

// C-67: half a unit in the last place of a texture coordinate, in texels of a side of `size` texels.
double half_ulp_in_texels(float coordinate, int size);

}  // namespace glassbox::study
