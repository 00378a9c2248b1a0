// The corners of triangles in clip space, and their outcodes, facing and attributes.
#pragma once

#include <array>

#include <glassbox/render/staged/primitives.h>

namespace glassbox {

// ---- clip space ----

Point<Clip> clip_position(const PrimitiveStage& stage, std::uint32_t index);
std::array<ClipVertex, 3> clip_vertices(const PrimitiveStage& stage, const Triangle& triangle);
std::array<Outcode, 3> outcodes_of(const PrimitiveStage& stage, const Triangle& triangle,
                                   const std::array<ClipVertex, 3>& corners);

// Clips a triangle to the view's planes. Most triangles are kept whole or rejected.
ClipPolygon clip_to_view(const PrimitiveStage& stage, const std::array<ClipVertex, 3>& corners,
                         ClipVerdict verdict);

// ---- facing ----

// Whether the triangle is certainly turned away; this is known before anything is clipped. For
// triangles that a plane cuts, the snapped area decides later.
bool is_culled_early(const PrimitiveStage& stage, const Triangle& triangle, ClipVerdict verdict);

// A triangle that is counter-clockwise in the world is counter-clockwise on the screen: the eye
// sees what a person there would see. A mirroring model matrix reverses the winding, and so
// exchanges front and back.
inline bool shows_front(const Draw& draw, const TriangleSetup& setup) {
  return setup.clockwise == draw.mirrored;
}

// ---- attributes ----

// All attributes except the results of lighting.
Varyings corner_attributes(const PrimitiveStage& stage, const Corner& corner);

// The attributes of the three corners as the fragments will interpolate them, lit where the shading
// is per face or per vertex. A surface seen from behind is lit as if its normals pointed the other
// way.
std::array<Varyings, 3> triangle_attributes(const PrimitiveStage& stage, const Triangle& triangle,
                                            bool front);

// The attributes at a vertex that clipping made, from the corners of the original primitive.
Varyings attributes_at(const std::array<Varyings, 3>& corners,
                       const std::array<double, 3>& weights);

}  // namespace glassbox
