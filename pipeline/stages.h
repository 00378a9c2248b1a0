// The records of the geometric stages, in the order in which a triangle passes through them:
//
//   Point<Object>   the vertex as modelled                                (mesh/)
//   Point<World>    world_from_object *                                   affine.h
//   Point<Eye>      eye_from_world *                                      look_at.h
//   ClipVertex      clip_from_eye *                                       projection.h
//   Outcode         the planes that the vertex is outside of              clip.h
//   ClipPolygon     the rest after clipping: 0, or 3 .. 10 vertices       clip.h
//   NdcVertex       divided by w                                          divide.h
//   ScreenVertex    scaled to the viewport's pixels                       viewport.h
//
// The later stages are in raster/stages.h.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/base/spaces.h>

namespace glassbox {

// A vertex of a triangle, or a point on it that clipping made. `weights` are its barycentric
// coordinates in the triangle before clipping (they sum to 1), so that attributes can be computed
// from the triangle's three corners alone.
struct ClipVertex {
  Point<Clip> position;
  std::array<double, 3> weights{};
};

// One bit for each plane; it is set where the vertex is outside the plane.
using Outcode = std::uint32_t;

// Every plane adds one vertex at most (Sutherland and Hodgman 1974): nine for the six planes of the
// frustum, and one more for the eye plane that `render` adds to them.
inline constexpr int kMaxClipPlanes = 7;
inline constexpr int kMaxClipVertices = 3 + kMaxClipPlanes;

struct ClipPolygon {
  std::array<ClipVertex, kMaxClipVertices> vertices;
  int count = 0;
};

struct NdcVertex {
  Point<Ndc> position;
  float inverse_w = 1;  // 1 / (distance along the gaze); exactly 1 for parallel projections
};

struct ScreenVertex {
  Point<Screen> position;  // x, y in pixels; z is the depth of NDC, unchanged
  float inverse_w = 1;
};

}  // namespace glassbox
