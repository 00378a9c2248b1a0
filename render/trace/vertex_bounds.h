// Bounds of single vertices, from a mesh's position to the screen (bounds.h combines them).
#pragma once

#include <glassbox/render/trace/bounds.h>

namespace glassbox {

// The bound of a position in clip space.
glm::dvec4 clip_bound(const Point<Object>& object, const TracedDraw& draw,
                      const DrawBounds& bounds);

// The bounds from clip space to the screen.
VertexBounds vertex_bounds(const Trace& trace, const TracedVertex& vertex,
                           const ClipVertexBound& clip);

// The largest distance of the snapped vertex from the exact one along x or y, in pixels. Infinite
// if there is no bound.
double snapped_bound(const TracedVertex& vertex, const VertexBounds& bounds);

}  // namespace glassbox
