// Bounds of single vertices, from a mesh's position to the screen (bounds.h combines them).
#pragma once

#include <glassbox/render/trace/bounds.h>

namespace glassbox {

// Returns the error bounds of a position in clip space.
glm::dvec4 clip_bound(const Point<Object>& object, const TracedDraw& draw,
                      const DrawBounds& bounds);

// Returns the error bounds of a vertex from clip space to the screen.
VertexBounds vertex_bounds(const Trace& trace, const TracedVertex& vertex,
                           const ClipVertexBound& clip);

// Returns the largest distance of the snapped vertex from the exact one along x or y, in pixels;
// infinite if there is no bound.
double snapped_bound(const TracedVertex& vertex, const VertexBounds& bounds);

}  // namespace glassbox
