// The attributes of a mesh's corners with bounds on their errors: positions and normals in eye
// space, light at the vertices, and the attributes at vertices that clipping makes.
#pragma once

#include <array>

#include <glassbox/mesh/mesh.h>
#include <glassbox/pipeline/clip_bounds.h>
#include <glassbox/raster/bounded_formulas.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/trace/bounds.h>

namespace glassbox {

using BoundedVaryings = VaryingsOf<bounded::Bounded>;

struct CornerStage {
  const Draw& draw;
  const DrawBounds& bounds;
  const Lighting& lighting;
  const RenderSettings& settings;
};

// `front`: whether the front of the face is seen.
BoundedVaryings face_corner_attributes(const CornerStage& stage, std::uint32_t face,
                                       const Corner& corner, bool front);
BoundedVaryings corner_of_line(const CornerStage& stage, const Corner& corner);

// Returns the attributes at a vertex of the polygon that clipping has left of three corners.
BoundedVaryings at_vertex(const std::array<BoundedVaryings, 3>& corners, const ClipVertex& vertex,
                          const ClipVertexBound& bound);

}  // namespace glassbox
