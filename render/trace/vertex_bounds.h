// Bounds of single vertices, from a mesh's position to the screen (bounds.h takes them together).
#pragma once

#include <glassbox/render/trace/bounds.h>

namespace glassbox {

// Of a position in clip space.
glm::dvec4 clip_bound(const Point<Object>& object, const TracedDraw& draw,
                      const DrawBounds& bounds);

// On the way from there to the screen.
VertexBounds vertex_bounds(const Trace& trace, const TracedVertex& vertex,
                           const ClipVertexBound& clip);

// How far the snapped vertex may be from the exact one, in pixels: the larger of x and y. Infinite where nothing can be said.
double snapped_bound(const TracedVertex& vertex, const VertexBounds& bounds);

}  // namespace glassbox
