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

// Clips a triangle to the view's planes. `verdict` says whether that is needed: most triangles are
// kept whole or rejected.
ClipPolygon clip_to_view(const PrimitiveStage& stage, const std::array<ClipVertex, 3>& corners,
                         ClipVerdict verdict);

// ---- facing ----

// Whether the triangle is certainly turned away; found before anything is clipped. For a triangle
// that a plane cuts the answer is false: the area after snapping decides later.
bool is_culled_early(const PrimitiveStage& stage, const Triangle& triangle, ClipVerdict verdict);

// Whether the viewer sees the triangle's front. A triangle that is counter-clockwise in the world
// is counter-clockwise on the screen: the eye sees what a person there would see. A mirroring model
// matrix reverses the winding, and so exchanges front and back.
inline bool shows_front(const Draw& draw, const TriangleSetup& setup) {
  return setup.clockwise == draw.mirrored;
}

// ---- attributes ----

// Returns all attributes of a corner except the results of lighting.
Varyings corner_attributes(const PrimitiveStage& stage, const Corner& corner);

// Returns the attributes of the three corners as the fragments will interpolate them, including
// light if the shading is per face or per vertex. A surface seen from behind is lit as if its
// normals pointed the other way.
std::array<Varyings, 3> triangle_attributes(const PrimitiveStage& stage, const Triangle& triangle,
                                            bool front);

// Returns the attributes at a vertex that clipping made, from those of the corners of the original
// primitive.
Varyings attributes_at(const std::array<Varyings, 3>& corners,
                       const std::array<double, 3>& weights);

}  // namespace glassbox
