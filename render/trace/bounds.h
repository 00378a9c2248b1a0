// How exact the numbers of a trace are: the running error bounds of SPEC C (generic bounds 1 to 5, 7 and 8), each handed on
// to the next stage. Computed on request, since most traces are made for their facts.
//
// What counts as exact is what was given: the positions of the mesh, and in double the matrices world_from_object,
// eye_from_world and clip_from_eye. Bounds are absolute, in the unit of their number.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/bounds.h>
#include <glassbox/pipeline/clip_bounds.h>
#include <glassbox/pipeline/round_trip.h>
#include <glassbox/raster/bounds.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

struct DrawBounds {
  glm::dmat4 clip_from_anchored{0};  // per entry: products in double, then one rounding to float
  glm::dmat4 eye_from_anchored{0};
  std::optional<ObjectViewer> viewer;  // for the test of back faces in object space
  WayThere way;                        // by the three matrices in double, for the way back
};

struct CornerBounds {
  glm::dvec3 world{0}, eye{0};
  glm::dvec4 clip{0};
  glm::dvec4 clip_magnitude{0};  // |M||x|: what a relative change of the input is multiplied by
  std::optional<RoundTrip> round_trip;  // to the screen and back; none where w is not positive
};

// On which side of a plane a corner is: negative outside.
struct PlaneDistance {
  double distance = 0;
  double bound = 0;
};

struct VertexBounds {
  ClipVertexBound clip;
  DivideBound ndc;
  glm::dvec3 condition{0};  // of NDC x, y, z; of corners that clipping left alone, otherwise zero
  glm::dvec3 screen{0};     // pixels, pixels, depth
  SnapStability snap_x, snap_y;
};

struct TriangleBounds {
  std::array<CornerBounds, 3> corners;
  std::vector<VertexBounds> polygon;  // as TracedTriangle::polygon
  // By piece, square pixels: that of the snapped piece against the exact one.
  std::vector<double> double_area;
  std::optional<BackFaceTest> back_face;  // in object space; none where there is no test to be made
};

DrawBounds bounds_of(const TracedDraw& draw, const View& view);

TriangleBounds bounds_of(const Trace& trace, const TracedTriangle& triangle, const TracedDraw& draw,
                         const DrawBounds& draw_bounds);

std::array<PlaneDistance, kMaxClipPlanes> plane_distances(const Trace& trace,
                                                          const TracedCorner& corner,
                                                          const CornerBounds& bounds);

// Of a fragment of that triangle; the numbers of its vertices are exact up to their own bounds.
SetupBounds setup_bounds(const TracedPiece& piece, const TriangleBounds& bounds);

}  // namespace glassbox
