// Clipping in homogeneous clip space, before the divide (S3-11, S3-13; Blinn and Newell 1978;
// Sutherland and Hodgman 1974). Without clipping, the divide would map points behind the eye to
// positions in front of it.
//
// There is one clipper for all uses. `render` passes render_planes(): triangles that leave the
// screen are not clipped inside the guard band, so rounded crossings do not move their edges. Labs
// and studies pass the six planes of the frustum.
//
// The clipper is watertight by construction. The point where an edge A-B crosses a plane depends on
// A and B alone, not on their order. With the distances dA and dB of A and B from the plane, it is
// (A |dB| + B |dA|) / (|dA| + |dB|) per coordinate, computed in double and rounded once to float.
// Two triangles that share an edge get the same bits for the crossing, for each plane in turn
// (C-38, B.1).
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

// The half-space a x + b y + c z + d w + e >= 0 of clip space. With e = 0 the result does not
// depend on the scale of (x, y, z, w). For the eye plane, w + e >= 0 with e < 0, it does, because w
// is a distance along the gaze.
struct ClipPlane {
  double a = 0, b = 0, c = 0, d = 0, e = 0;
  const char* name = "";
};

// The half-spaces 0 <= z <= w, -w <= x <= w, -w <= y <= w, in the order near, far, left, right,
// bottom, top. kReversed swaps near and far; the half-spaces are the same.
std::array<ClipPlane, 6> frustum_planes(DepthRange depth_range = DepthRange::kStandard);

// z >= -w: the near plane of the OpenGL dialect (E16). Its far plane is z <= w, as here.
ClipPlane opengl_near_plane();

// The four planes |screen x - centre| <= kGuardBandPx and likewise y, that is 2^16 w -+ W x >= 0
// for a viewport W px wide. The guard band is wider than any viewport that the program accepts, and
// narrow enough for the integers of raster/ (B.2).
inline constexpr double kGuardBandPx = 32768;
std::array<ClipPlane, 4> guard_band_planes(const Viewport& viewport);

// The planes that `render` clips by, in this order: near; eye (w >= near/2 for perspective, 1/2 for
// parallel views); far; guard band.
//
// In exact arithmetic every point inside the near plane is inside the eye plane. With rounded
// matrices it need not be: z and w are rounded separately, and a large offset may give z >= 0 where
// w <= 0. After clipping w >= near/2 always holds, so that nothing divides by zero (C-33).
//
// For an infinite far plane of the standard range the far plane is z = w itself, and rounding puts
// every distant point on one side of it or the other. So z <= 2 w is used instead: it cuts only
// rounding noise and keeps z/w finite. A depth of slightly more than 1 is possible then.
std::array<ClipPlane, kMaxClipPlanes> render_planes(const View& view);

// The indices in the array of render_planes(); the four planes of the guard band follow.
inline constexpr std::size_t kNearPlane = 0, kEyePlane = 1, kFarPlane = 2;

// The plane's a x + b y + c z + d w + e for the position, in double. The sign is exact, and 0 only
// on the plane, for coefficients that are zero or of size 2^-200 .. 2^200 (base/expansion.h). The
// value is correct to a few ulps of its largest term.
double signed_distance(const ClipPlane& plane, const Point<Clip>& position);

// Bit i is set where the point is outside planes[i] (distance < 0; at most 31 planes). kNotFinite
// is set, with all other bits, where a coordinate is infinite or NaN, so that such a vertex is
// never accepted.
inline constexpr Outcode kNotFinite = 0x80000000u;
Outcode outcode(const Point<Clip>& position, std::span<const ClipPlane> planes);

// kAccept: all vertices are inside all planes, so clipping would change nothing (C-42). kReject:
// all vertices are outside the same plane, or a vertex is not finite.
enum class ClipVerdict { kReject, kAccept, kClip };
ClipVerdict trivial_verdict(std::span<const Outcode> outcodes);

// Whether a clip coordinate of some vertex in the box may overflow the range of float, or be more
// than half of its largest number.
bool may_overflow(const Box<Object>& box, const Transform<Clip, Object, float>& clip_from_object);

// The range of signed_distance() over boxes of object space, without transforming their contents.
// It holds for every vertex in the box, transformed in float in the order of operations of
// transform_row, provided that no coordinate overflows. A linear function over a box has its
// extremes at the corners; the rounding of the float transform, gamma_4 |M||x| (docs/references.md,
// bound 1), is included.
class PlaneOverBoxes {
public:
  PlaneOverBoxes(const ClipPlane& plane, const Transform<Clip, Object, float>& clip_from_object);

  struct Distances {
    double least = 0, greatest = 0;
  };
  Distances distance_range(const Box<Object>& box) const;
  // The range for a box given by its centre and half its size.
  Distances distance_range(const Point<Object, double>& centre,
                           const Vector<Object, double>& half) const;

private:
  // The distance is slope . p + offset, with an error of at most error . |p| + error_offset.
  Vector<Object, double> slope_, error_;
  double offset_ = 0, error_offset_ = 0;
};

// Like trivial_verdict for everything inside a box of object space, without transforming its
// contents. kAccept: every vertex in the box has outcode 0. kReject: for one of the planes every
// vertex is outside. An empty box is rejected.
ClipVerdict classify_box(const Box<Object>& box,
                         const Transform<Clip, Object, float>& clip_from_object,
                         std::span<const ClipPlane> planes);

// The effect of one plane on a polygon.
struct ClipStep {
  std::array<double, kMaxClipVertices> distances{};  // of the input vertices; negative: outside
  ClipPolygon after;
  // The origin of each vertex of `after`: {i, i} is input vertex i; {i, j} is the crossing of the
  // edge from i to j.
  std::array<std::array<int, 2>, kMaxClipVertices> sources{};
};

// Returns the part of a triangle inside all planes (at most kMaxClipPlanes): a convex polygon of 3
// to 3 + planes vertices in the triangle's order, beginning with its first corner that is kept, or
// an empty polygon. A vertex exactly on a plane is inside and is not repeated; vertices whose
// positions are equal after rounding are merged (C-35). The result is empty where less than a
// triangle remains, or where a position is not finite.
//
// A crossing (of an edge and a plane) is exactly on its plane. If only one of the plane's a, b, c
// is not zero, the coordinate x, y or z that belongs to it is computed from the rounded w (z = 0, z
// = w, x = -w, x = round(k w), ...). If all three are zero, w is computed. The other coordinates
// are between those of the edge's two ends. A condition such as x <= w, -w <= x or 0 <= z that both
// ends satisfy holds for the crossing too, since rounding is monotonic. For finite input nothing
// becomes infinite or NaN.
//
// `steps`, unless null, receives the result of clipping by each plane, up to the first plane that
// leaves nothing. Its last polygon may still repeat positions, which the returned one does not.
ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle,
                          std::span<const ClipPlane> planes,
                          std::vector<ClipStep>* steps = nullptr);

// A polygon is drawn as the triangles (0, i + 1, i + 2), i = 0 .. fan_size - 1.
int fan_size(const ClipPolygon& polygon);
std::array<ClipVertex, 3> fan_triangle(const ClipPolygon& polygon, int i);

// The part of a segment inside all planes. Returns nothing if nothing is left, or if only one point
// is left of a segment with two different ends.
std::optional<std::array<ClipVertex, 2>> clip_segment(const std::array<ClipVertex, 2>& segment,
                                                      std::span<const ClipPlane> planes);

// Whether a point is inside all planes.
bool clip_point(const Point<Clip>& position, std::span<const ClipPlane> planes);

}  // namespace glassbox
