// How exact the numbers of a trace are: the running error bounds of SPEC C (generic bounds 1 to 5, 7 and 8), each handed on
// to the next stage. Computed on request, since most traces are made for their facts.
//
// What counts as exact is what was given: the positions of the mesh, and in double the matrices world_from_object,
// eye_from_world and clip_from_eye. Bounds are absolute, in the unit of their number.
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

// What a fragment of the piece begins with: how exact depth and 1/w of the vertices are, up to their own bounds.
SetupBounds setup_bounds(const TracedPiece& piece, const TriangleBounds& bounds);

// ---- of a whole run ----

// The bounds of a run's records as they come, for sinks that keep nothing.
class BoundsOfRun {
public:
  struct Known {
    const TracedTriangle* triangle = nullptr;
    TriangleBounds bounds;
  };
  struct KnownDraw {
    TracedDraw draw;
    DrawBounds bounds;
  };

  explicit BoundsOfRun(const View& view);

  // Draws come before their triangles, triangles before their fragments.
  const DrawBounds& draw(const TracedDraw& draw);
  const Known& triangle(const TracedTriangle& triangle);
  // The fragment's triangle; null where the run's filter has left it out, and for lines and points.
  const Known* of(const TracedFragment& fragment);
  // The same by the triangle's number, of edges too.
  const Known* of_triangle(std::uint32_t number);
  const KnownDraw& of_instance(std::uint32_t instance) const { return draws_.at(instance); }

  // The view and the planes; nothing else.
  const Trace& trace() const { return trace_; }

private:
  struct Kept {
    TracedTriangle triangle;
    Known known;
  };

  Trace trace_;
  std::map<std::uint32_t, KnownDraw> draws_;  // by instance
  // By number: the last triangles, whose fragments are still to come, and those before them.
  std::map<std::uint32_t, Kept> latest_, earlier_;
  bool fragments_came_ = false;
};

// Of all triangles of a trace, by number; they stay where they are.
std::map<std::uint32_t, BoundsOfRun::Known> bounds_of_all(const Trace& trace);

// The bounds of a fragment of that triangle.
FragmentBounds bounds_of(const BoundsOfRun::Known& known, const TracedFragment& fragment);

// Which coordinate of which corner of which triangle.
struct RoundTripPlace {
  std::uint32_t triangle = 0;  // number in the whole scene
  std::uint32_t corner = 0;    // 0, 1 or 2
  std::uint32_t axis = 0;
};

// The round trips of a run taken together: object space to the screen in float and back (pipeline/round_trip.h).
struct RoundTrips {
  std::uint64_t corners = 0;    // of triangles, that have a place on the screen
  std::uint64_t unbounded = 0;  // of these, how many nothing can be said of
  // Of those that something can be said of, the coordinate that comes back furthest from where it was, in units of its object
  // space, with its bound and its place.
  double largest_error = 0;
  double bound = 0;
  RoundTripPlace place;
  // How much of its bound any coordinate uses: never more than 1.
  double largest_ratio = 0;

  void see(const TracedTriangle& triangle, const TriangleBounds& bounds);
};

}  // namespace glassbox
