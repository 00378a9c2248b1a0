// The corners of triangles in clip space, and what they bring with them: outcodes, facing, attributes.
#pragma once

#include <array>

#include <glassbox/render/staged/ready.h>

namespace glassbox {

// ---- clip space ----

Point<Clip> clip_position(const PrimitiveStage& stage, std::uint32_t index);
std::array<ClipVertex, 3> clip_vertices(const PrimitiveStage& stage, const Triangle& triangle);
std::array<Outcode, 3> outcodes_of(const PrimitiveStage& stage, const Triangle& triangle,
                                   const std::array<ClipVertex, 3>& corners);

// What the view's planes leave of a triangle; most are left whole, or nothing of them.
ClipPolygon clip_to_view(const PrimitiveStage& stage, const std::array<ClipVertex, 3>& corners,
                         ClipVerdict verdict);

// ---- facing ----

// Turned away for certain, which is known before anything is clipped. What a plane cuts is left to the snapped area.
bool is_culled_early(const PrimitiveStage& stage, const Triangle& triangle, ClipVerdict verdict);

// Counter-clockwise in the world is counter-clockwise on the screen: the eye sees what a person there would see. A
// mirroring model matrix turns the winding round, and the outside with it.
inline bool shows_front(const Draw& draw, const TriangleSetup& setup) {
  return setup.clockwise == draw.mirrored;
}

// ---- attributes ----

// Everything but the lighting.
Varyings corner_attributes(const PrimitiveStage& stage, const Corner& corner);

// The three corners as the fragments will interpolate them, lit where the shading is per face or per vertex. Seen from
// behind, a surface is lit as if its normals pointed the other way.
std::array<Varyings, 3> triangle_attributes(const PrimitiveStage& stage, const Triangle& triangle,
                                            bool front);

// The attributes at a vertex that clipping made, from the corners of the primitive as it came.
Varyings attributes_at(const std::array<Varyings, 3>& corners,
                       const std::array<double, 3>& weights);

}  // namespace glassbox
