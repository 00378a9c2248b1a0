// Clipping in homogeneous clip space, before the divide (S3-11, S3-13; Blinn and Newell 1978; Sutherland and Hodgman
// 1974): points behind the eye would otherwise be mapped to the front.
//
// One clipper serves all: `render` passes render_planes(), which keep what leaves the screen until the guard band and so
// do not move the triangle's edges; labs and studies pass the six planes of the frustum.
//
// Watertight by construction. A crossing of an edge A-B with a plane depends on A and B alone, not on their order: it is
// (A |dB| + B |dA|) / (|dA| + |dB|) per coordinate in double, rounded once to float. Two triangles that share an edge cut
// it at the same bits, again and again through all planes (C-38, SPEC B.1).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glassbox/base/box.h>
#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// The half-space a x + b y + c z + d w + e >= 0 of clip space. With e = 0 it does not ask how (x, y, z, w) is scaled;
// the eye plane, w >= e, does, because w is a distance along the gaze.
struct ClipPlane {
  double a = 0, b = 0, c = 0, d = 0, e = 0;
  const char* name = "";
};

// 0 <= z <= w, -w <= x <= w, -w <= y <= w, in the order near, far, left, right, bottom, top. kReversed swaps near and far
// and leaves the half-spaces alone.
std::array<ClipPlane, 6> frustum_planes(DepthRange depth_range = DepthRange::kStandard);

// z >= -w: the near plane of the OpenGL dialect (SPEC E16). Its far plane is the same, z <= w.
ClipPlane opengl_near_plane();

// |screen x - centre| <= kGuardBandPx and likewise y, that is 2^16 w -+ W x >= 0 for a viewport W px wide. Wider than
// any viewport that the program accepts, and narrow enough for the integers of raster/ (SPEC B.2).
inline constexpr double kGuardBandPx = 32768;
std::array<ClipPlane, 4> guard_band_planes(const Viewport& viewport);

// What `render` clips by, in this order: near; eye (w >= near/2 for perspective, 1/2 for parallel views); far; guard band.
//
// The eye plane repeats what the near plane says in exact arithmetic. With rounded matrices it does not follow: z and w
// are rounded separately, and a large offset may give z >= 0 where w <= 0. After clipping w >= near/2 holds always, so
// that nothing divides by zero (C-33).
//
// An infinite far plane of the standard range is z = w itself, where every distant point lies by rounding, on either
// side. So that plane is left out there, and z <= 2 w stands in for it: it cuts nothing but noise and keeps z/w finite. A
// depth of slightly more than 1 is possible then.
std::array<ClipPlane, kMaxClipPlanes> render_planes(const View& view);

// Where they stand in it; the four of the guard band follow.
inline constexpr std::size_t kNearPlane = 0, kEyePlane = 1, kFarPlane = 2;

// a x + b y + c z + d w + e in double. The sign is exact, 0 only on the plane, for coefficients that are zero or 2^-200 ..
// 2^200 in size (base/expansion.h); the value is right to a few ulps of its largest term.
double signed_distance(const ClipPlane& plane, const Point<Clip>& position);

// Bit i for planes[i] (at most 31): outside, distance < 0. kNotFinite, with all the other bits, where a coordinate is
// infinite or NaN, so that such a vertex is never accepted.
inline constexpr Outcode kNotFinite = 0x80000000u;
Outcode outcode(const Point<Clip>& position, std::span<const ClipPlane> planes);

// Accept: all vertices are inside all planes, and clipping would change nothing (C-42). Reject: all are outside one
// plane, or one of them is not finite.
enum class ClipVerdict { kReject, kAccept, kClip };
ClipVerdict trivial_verdict(std::span<const Outcode> outcodes);

// Whether some coordinate of a vertex in the box may be too large for a float, or near it.
bool may_overflow(const Box<Object>& box, const Transform<Clip, Object, float>& clip_from_object);

// What signed_distance() is over boxes of object space, without transforming their contents: of every vertex in the box, transformed in
// float by transform_row's order of operations, provided that no coordinate overflows. The extremes of a linear function over a box are
// at its corners; the rounding of the float transform, gamma_4 |M||x| (SPEC C, generic bound 1), is taken into account.
class PlaneOverBoxes {
public:
  PlaneOverBoxes(const ClipPlane& plane, const Transform<Clip, Object, float>& clip_from_object);

  struct Distances {
    double least = 0, greatest = 0;
  };
  Distances over(const Box<Object>& box) const;
  // The same by the box's centre and half its size.
  Distances over(const Point<Object, double>& centre, const Vector<Object, double>& half) const;

private:
  // slope . p + offset, and what it may be off by: error . |p| + error_offset.
  Vector<Object, double> slope_, error_;
  double offset_ = 0, error_offset_ = 0;
};

// The same as trivial_verdict for everything inside a box of object space, without transforming its contents: kAccept means that every
// vertex in the box has outcode 0, and kReject that for one of the planes every one is outside. An empty box is rejected.
ClipVerdict classify_box(const Box<Object>& box,
                         const Transform<Clip, Object, float>& clip_from_object,
                         std::span<const ClipPlane> planes);

// What one plane did to a polygon.
struct ClipStep {
  std::array<double, kMaxClipVertices> distances{};  // of the vertices that came; negative: outside
  ClipPolygon after;
  // Where each vertex of `after` comes from: {i, i}, vertex i as it came; {i, j}, the crossing of the edge from i to j.
  std::array<std::array<int, 2>, kMaxClipVertices> sources{};
};

// The part of a triangle inside all planes (at most kMaxClipPlanes): a convex polygon of 3 .. 3 + planes vertices in the triangle's
// order, beginning with its first corner that is kept; or none. A vertex exactly on a plane is inside and is not
// repeated; vertices whose positions coincide after rounding are merged (C-35). Nothing is kept where less than a
// triangle remains, or where a position is not finite.
//
// A crossing lies exactly on its plane: with one of a, b, c non-zero, that coordinate is computed from the rounded w (z =
// 0, z = w, x = -w, x = round(k w), ...), with none of them w is. Its other coordinates lie between those of its ends,
// and whatever both ends satisfy of x <= w, -w <= x, 0 <= z and so on they satisfy too, since rounding is monotonic. For
// finite input nothing becomes infinite or NaN.
//
// `steps`, unless null, is given what each plane did, until one leaves nothing. The last one's polygon may still repeat
// positions.
ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle,
                          std::span<const ClipPlane> planes,
                          std::vector<ClipStep>* steps = nullptr);

// A polygon is drawn as the triangles (0, i + 1, i + 2), i = 0 .. fan_size - 1.
int fan_size(const ClipPolygon& polygon);
std::array<ClipVertex, 3> fan_triangle(const ClipPolygon& polygon, int i);

// The part of a segment inside all planes; none where nothing, or one point of a longer segment, is left.
std::optional<std::array<ClipVertex, 2>> clip_segment(const std::array<ClipVertex, 2>& segment,
                                                      std::span<const ClipPlane> planes);

// Whether a point is inside all planes.
bool clip_point(const Point<Clip>& position, std::span<const ClipPlane> planes);

}  // namespace glassbox
