// How accurate the numbers of a trace are: running error bounds, each propagated to the next stage
// (bounds 1 to 5, 7 and 8 of SPEC C in docs/references.md). They are computed only on request,
// because most traces are made for the numbers alone.
//
// These inputs are taken as exact: the positions of the mesh, and the matrices world_from_object,
// eye_from_world and clip_from_eye in double. Bounds are absolute, in the unit of their number.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
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
  // The bounds of the matrices' entries: of the products in double, and of one rounding to float.
  glm::dmat4 clip_from_anchored{0};
  glm::dmat4 eye_from_anchored{0};
  std::optional<ObjectViewer> viewer;  // for the back-face test in object space
  ForwardTransform forward_transform;  // object to screen in double, for the round trip
};

struct CornerBounds {
  glm::dvec3 world{0}, eye{0};
  glm::dvec4 clip{0};
  glm::dvec4 clip_magnitude{0};         // |M| |x|: bounds the effect of a relative change of M or x
  std::optional<RoundTrip> round_trip;  // to the screen and back; none where w is not positive
};

// The signed distance of a corner from a plane (negative outside), and the bound of its error.
struct PlaneDistance {
  double distance = 0;
  double bound = 0;
};

struct VertexBounds {
  ClipVertexBound clip;
  DivideBound ndc;
  // The condition numbers of NDC x, y, z; zero for vertices that clipping made.
  glm::dvec3 condition{0};
  glm::dvec3 screen{0};  // x and y in pixels, and depth
  SnapStability snap_x, snap_y;
};

struct TriangleBounds {
  std::array<CornerBounds, 3> corners;
  std::vector<VertexBounds> polygon;  // same order as TracedTriangle::polygon
  // For each triangle of the fan, in square pixels: how much twice its area after snapping may
  // differ from the exact value.
  std::vector<double> double_area;
  std::optional<BackFaceTest> back_face;  // in object space; none if there is no test
};

DrawBounds bounds_of(const TracedDraw& draw, const View& view);

TriangleBounds bounds_of(const Trace& trace, const TracedTriangle& triangle, const TracedDraw& draw,
                         const DrawBounds& draw_bounds);

std::array<PlaneDistance, kMaxClipPlanes> plane_distances(const Trace& trace,
                                                          const TracedCorner& corner,
                                                          const CornerBounds& bounds);

// Returns the bounds of the vertices' depth and 1/w, from which the bounds of a fragment begin.
SetupBounds setup_bounds(const TracedPiece& piece, const TriangleBounds& bounds);

// ---- bounds of a whole run ----

// The bounds of a run's records, computed as the records come, for sinks that keep no records.
class BoundsOfRun {
public:
  struct KnownTriangle {
    const TracedTriangle* triangle = nullptr;
    TriangleBounds bounds;
  };
  struct KnownDraw {
    TracedDraw draw;
    DrawBounds bounds;
  };

  explicit BoundsOfRun(const View& view);

  // draw() must be called before triangle() for the draw's triangles, and triangle() before
  // of_fragment() for the triangle's fragments.
  const DrawBounds& draw(const TracedDraw& draw);
  const KnownTriangle& triangle(const TracedTriangle& triangle);
  // Returns the fragment's triangle; null if the run's filter has left it out, and for lines and
  // points.
  const KnownTriangle* of_fragment(const TracedFragment& fragment);
  // Returns the triangle with this number, or null; also for edges that are drawn as lines.
  const KnownTriangle* of_triangle(std::uint32_t number);
  const KnownDraw& of_instance(std::uint32_t instance) const { return draws_.at(instance); }

  // A trace that contains the view and the planes only.
  const Trace& trace() const { return trace_; }

private:
  struct Kept {
    TracedTriangle triangle;
    KnownTriangle known;
  };

  Trace trace_;
  std::map<std::uint32_t, KnownDraw> draws_;  // by instance
  // Triangles by number: the latest ones, whose fragments are still to come, and the batch before
  // them.
  std::map<std::uint32_t, Kept> latest_, earlier_;
  bool fragments_came_ = false;
};

// Returns the bounds of all triangles of a trace, by number. The result refers to the trace's
// triangles.
std::map<std::uint32_t, BoundsOfRun::KnownTriangle> bounds_of_all(const Trace& trace);

// Returns the bounds of a fragment of the triangle `known`.
FragmentBounds bounds_of(const BoundsOfRun::KnownTriangle& known, const TracedFragment& fragment);

// Identifies a coordinate of a corner of a triangle.
struct RoundTripPlace {
  std::uint32_t triangle = 0;  // number in the whole scene
  std::uint32_t corner = 0;    // 0, 1 or 2
  std::uint32_t axis = 0;
};

// A summary of the round trips of a run: from object space to the screen in float and back
// (pipeline/round_trip.h).
struct RoundTrips {
  std::uint64_t corners = 0;    // corners of triangles that have a place on the screen
  std::uint64_t unbounded = 0;  // how many of these corners have no bound
  // Among the corners with a bound, the coordinate that comes back furthest from its original
  // value: its error in units of its object space, its bound and its place.
  double largest_error = 0;
  double bound = 0;
  RoundTripPlace place;
  // The largest ratio of an error to its bound: never more than 1.
  double largest_ratio = 0;

  void add(const TracedTriangle& triangle, const TriangleBounds& bounds);
};

}  // namespace glassbox
