// The records of a trace: the results of the stages (pipeline/stages.h and raster/stages.h) as a
// run made them, with the decisions of its tests.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// ---- draws ----

// One instance of a mesh as the run draws it.
struct TracedDraw {
  std::uint32_t instance = 0;      // index into Scene::instances
  std::uint32_t first_number = 0;  // number of the draw's first triangle in the whole scene
  Transform<World, Object> world_from_object;
  Vector<Object> anchor;  // subtracted from positions first; the subtraction is exact
  Transform<Clip, Object, float> clip_from_anchored;
  Transform<Eye, Object, float> eye_from_anchored;
  bool mirrored = false;  // front faces run clockwise
};

// ---- triangles ----

struct TracedCorner {
  std::uint32_t corner = 0;    // index into Mesh::corners
  std::uint32_t position = 0;  // index into Mesh::positions
  Point<Object> object;        // as modelled
  Point<World, double> world;  // world_from_object * object, in double
  Point<Eye, double> eye;      // eye_from_world * world, in double
  Point<Clip> clip;            // computed by the run with one float matrix
  Outcode outcode = 0;         // for the planes of the run
  friend bool operator==(const TracedCorner&, const TracedCorner&) = default;
};

// A vertex of the polygon after clipping.
struct TracedVertex {
  ClipVertex clip;
  NdcVertex ndc;
  ScreenVertex screen;
  SnappedVertex snapped;
};

// One triangle of the fan into which the clipped polygon is split.
struct TracedPiece {
  std::array<std::size_t, 3> polygon{};  // indices of its vertices in the polygon
  std::array<ScreenVertex, 3> vertices;
  std::optional<TriangleSetup> setup;  // none: no area after snapping
  bool front = false;                  // the viewer sees its front; set only if there is a setup
  bool culled = false;
};

struct TracedTriangle {
  std::uint32_t number = 0;    // number in the whole scene
  std::uint32_t instance = 0;  // index into Scene::instances
  std::uint32_t face = 0;      // index into Mesh::faces
  std::array<TracedCorner, 3> corners;
  // What each plane of Trace::planes left, in order, until nothing was left. Empty if clipping was
  // not needed: all corners were inside all planes, or all outside one plane.
  std::vector<ClipStep> clipping;
  std::vector<TracedVertex> polygon;  // after clipping; empty: nothing is left
  std::vector<TracedPiece> pieces;
};

// Returns the corners before clipping.
inline std::array<ClipVertex, 3> clip_vertices(const TracedTriangle& triangle) {
  std::array<ClipVertex, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k].position = triangle.corners[k].clip;
    vertices[k].weights[k] = 1.0;
  }
  return vertices;
}

// ---- fragments ----

struct TracedFragment {
  FragmentSource source;
  std::uint32_t instance = 0;
  Coverage coverage;  // for triangles: the integer edge functions
  Fragment fragment;
  std::uint32_t code = 0;    // its depth code
  std::uint32_t stored = 0;  // the code that the buffer held
  FragmentResult result = FragmentResult::kHidden;
  // Set if the fragment passed the depth test:
  Varyings at;
  Rgba surface;
  // Set if the fragment was written or blended:
  std::array<float, 3> emission{};  // the surface's own light, included in `light`
  Rgba light;                       // linear; set only if the picture shows light
  Rgba8 before, after;
};

// ---- the whole trace ----

struct Trace {
  View view;
  RenderSettings settings;
  // The planes of the run's clipping: render_planes.
  std::array<ClipPlane, kMaxClipPlanes> planes{};
  std::vector<TracedDraw> draws;  // all draws, in drawing order, for any filter
  std::vector<TracedTriangle> triangles;
  std::vector<TracedFragment> fragments;  // in the order in which they were drawn
  bool complete = true;                   // false: the filter's limit of bytes was reached
};

}  // namespace glassbox
