#include <glassbox/render/staged/vertex_stage.h>

#include <algorithm>
#include <optional>

#include <glassbox/mesh/normals.h>

namespace glassbox {

namespace {

Point<Object> relative_to_anchor(const Draw& draw, const Point<Object>& position) {
  return {position.x - draw.anchor.x, position.y - draw.anchor.y, position.z - draw.anchor.z};
}

}  // namespace

Point<Clip> project_vertex(const Draw& draw, std::uint32_t index) {
  return draw.clip_from_anchored * relative_to_anchor(draw, draw.mesh->positions[index]);
}

float project_x(const Draw& draw, std::uint32_t index) {
  return transform_row(draw.clip_from_anchored, 0,
                       relative_to_anchor(draw, draw.mesh->positions[index]));
}

bool needs_normals(const Draw& draw, const RenderSettings& settings) {
  return settings.show == Show::kNormal || shows_light(draw, settings);
}

bool shows_light(const Draw& draw, const RenderSettings& settings) {
  return settings.show == Show::kColor && settings.shading != Shading::kUnlit &&
         !draw.material->unlit;
}

bool needs_face_normals(const Draw& draw, const RenderSettings& settings) {
  return settings.shading == Shading::kFlat || !draw.prepared->all_have_normals;
}

void append_face_normals(const Draw& draw, std::vector<Normal<Eye>>& normals) {
  for (const Face& face : draw.mesh->faces) {
    const std::optional<Normal<Object>> normal = face_normal(*draw.mesh, face);
    normals.push_back(normal ? normalized(draw.eye_normal_from_object * *normal) : Normal<Eye>{});
  }
}

EyeSpaceTables make_eye_space_tables(const Draw& draw, const RenderSettings& settings) {
  EyeSpaceTables tables;
  if (!needs_normals(draw, settings)) return tables;

  const Mesh& mesh = *draw.mesh;
  tables.positions.reserve(mesh.positions.size());
  for (const Point<Object>& position : mesh.positions) {
    tables.positions.push_back(draw.eye_from_anchored * relative_to_anchor(draw, position));
  }
  tables.normals.reserve(mesh.normals.size());
  for (const Normal<Object>& normal : mesh.normals) {
    tables.normals.push_back(normalized(draw.eye_normal_from_object * normal));
  }
  if (needs_face_normals(draw, settings)) append_face_normals(draw, tables.face_normals);
  return tables;
}

}  // namespace glassbox
