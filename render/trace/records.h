// What a trace holds: the records of pipeline/stages.h and raster/stages.h, as a run made them, with what was decided.
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

// One instance of a mesh, as the run draws it.
struct TracedDraw {
  std::uint32_t instance = 0;      // index into Scene::instances
  std::uint32_t first_number = 0;  // of its first triangle, in the whole scene
  Transform<World, Object> world_from_object;
  Vector<Object> anchor;  // subtracted from positions first, exactly
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
  Point<Clip> clip;            // as the run computed it, by one float matrix
  Outcode outcode = 0;         // against the planes of the run
  friend bool operator==(const TracedCorner&, const TracedCorner&) = default;
};

// A vertex of what clipping left.
struct TracedVertex {
  ClipVertex clip;
  NdcVertex ndc;
  ScreenVertex screen;
  SnappedVertex snapped;
};

// One triangle of the fan that the clipped polygon is cut into.
struct TracedPiece {
  std::array<std::size_t, 3> polygon{};  // which of the polygon's vertices
  std::array<ScreenVertex, 3> vertices;
  std::optional<TriangleSetup> setup;  // none: no area after snapping
  bool front = false;                  // where it is set up
  bool culled = false;
};

struct TracedTriangle {
  std::uint32_t number = 0;    // in the whole scene
  std::uint32_t instance = 0;  // index into Scene::instances
  std::uint32_t face = 0;      // index into Mesh::faces
  std::array<TracedCorner, 3> corners;
  // What each of Trace::planes did, in order, until nothing was left. Empty where none of them had anything to do: all
  // corners inside, or all outside one plane.
  std::vector<ClipStep> clipping;
  std::vector<TracedVertex> polygon;  // after clipping; empty: nothing was left
  std::vector<TracedPiece> pieces;
};

// The corners as they come to the clipper.
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
  Coverage coverage;  // of triangles: the integer edge functions
  Fragment fragment;
  std::uint32_t code = 0;    // its depth, as the buffer stores it
  std::uint32_t stored = 0;  // what the buffer held
  Fate fate = Fate::kHidden;
  // Where it passed the depth test:
  Varyings at;
  Rgba surface;
  // Where it was written or blended:
  std::array<float, 3> emission{};  // part of the light: the surface's own
  Rgba light;                       // linear; of pictures of light only
  Rgba8 before, after;
};

// ---- the whole ----

struct Trace {
  View view;
  RenderSettings settings;
  std::array<ClipPlane, kMaxClipPlanes> planes{};  // what the run clipped by: render_planes
  std::vector<TracedDraw> draws;  // in drawing order; all of them, whatever the filter
  std::vector<TracedTriangle> triangles;
  std::vector<TracedFragment> fragments;  // in the order in which they came
  bool complete = true;                   // false: the filter's bytes were used up
};

}  // namespace glassbox
