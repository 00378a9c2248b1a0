// Culls what neither eye sees (S0-04). The eyes share y, z and w, so eight planes bound both
// frusta: near, far, bottom and top once, left and right for each eye.
//
// The test is exact for points: the outcodes compare the floats that both eyes draw, with no
// rounding in between. It is conservative for triangles and boxes: a triangle is culled where one
// plane of each eye's frustum has all its corners outside, a box where that holds for every vertex
// that it may contain, rounding included. So nothing that an eye draws is ever culled, while some
// things that neither eye draws are kept.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include <glassbox/base/box.h>
#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>

namespace glassbox {

// A vertex in the clip spaces of both eyes.
struct StereoClipPoint {
  float left_x = 0, right_x = 0, y = 0, z = 0, w = 0;
};
inline StereoClipPoint stereo_clip_point(const Point<Clip>& left, const Point<Clip>& right) {
  return {left.x, right.x, left.y, left.z, left.w};
}
// For culling with one camera for both eyes, as in the slides: the camera in the middle loses what
// only the skewed frusta of the eyes see (E20).
inline StereoClipPoint centre_clip_point(const Point<Clip>& centre) {
  return {centre.x, centre.x, centre.y, centre.z, centre.w};
}

struct StereoPlanes {
  std::array<ClipPlane, 4> shared;  // near, far, bottom, top
  std::array<ClipPlane, 2> sides;   // left and right plane, used for each eye
};
// An infinite far plane of the standard range is replaced by z <= 2 w, as in render_planes.
StereoPlanes stereo_planes(const View& centre);

// Bits 0 and 1: z < 0, z beyond the other end of the depth range; 2 and 3: below, above; 4 and 5:
// to the left and to the right of the left eye's frustum; 6 and 7: of the right eye's. A vertex
// that is not finite for the left or right eye has bit 8 or 9.
Outcode stereo_outcode(const StereoClipPoint& point, const View& centre);
inline constexpr Outcode kStereoSides = 0xfc;  // bits 2 to 7

// Whether neither eye can see anything of the triangle (or segment, or point) with these outcodes.
bool is_outside_both_views(std::span<const Outcode> outcodes);

// Whether neither eye can see anything that is in a box of object space. To cull by the centre
// camera alone, pass its matrix twice.
bool is_box_outside_both_views(const Box<Object>& box,
                               const Transform<Clip, Object, float>& left_clip_from_object,
                               const Transform<Clip, Object, float>& right_clip_from_object,
                               const StereoPlanes& planes);

// The number of columns, px, at one edge of each eye's picture that culling by the centre camera
// leaves empty for objects at this distance: half the parallax. The left eye loses its right edge
// behind the window and its left edge in front of it.
inline double missing_strip_px(const View& centre, const StereoPair& pair, double distance) {
  return std::abs(parallax_at(centre, pair, distance).px) / 2;
}

}  // namespace glassbox
