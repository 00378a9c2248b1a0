#include <glassbox/render/vertex_stage.h>

#include <algorithm>
#include <optional>

#include <glassbox/mesh/normals.h>

namespace glassbox {

namespace {

bool needs_face_normals(const Draw& draw, const RenderSettings& settings) {
  const auto has_none = [](const Corner& corner) { return corner.normal == kNone; };
  return settings.shading == Shading::kFlat || std::ranges::any_of(draw.mesh->corners, has_none);
}

Point<Object> relative_to_anchor(const Draw& draw, const Point<Object>& position) {
  return {position.x - draw.anchor.x, position.y - draw.anchor.y, position.z - draw.anchor.z};
}

}  // namespace

bool needs_normals(const Draw& draw, const RenderSettings& settings) {
  if (settings.show == Show::kNormal) return true;
  return settings.show == Show::kColor && settings.shading != Shading::kUnlit &&
         !draw.material->unlit;
}

VertexTables transform_vertices(const Draw& draw, const RenderSettings& settings,
                                Observer* observer) {
  const Mesh& mesh = *draw.mesh;
  const bool lit = needs_normals(draw, settings);

  VertexTables tables;
  tables.clip.reserve(mesh.positions.size());
  if (lit) tables.eye.reserve(mesh.positions.size());
  for (const Point<Object>& position : mesh.positions) {
    const Point<Object> anchored = relative_to_anchor(draw, position);
    Point<Clip> clip = draw.clip_from_anchored * anchored;
    if (observer != nullptr) {
      observer->projected(draw, std::uint32_t(tables.clip.size()), clip);
    }
    tables.clip.push_back(clip);
    if (lit) tables.eye.push_back(draw.eye_from_anchored * anchored);
  }
  if (!lit) return tables;

  for (const Normal<Object>& normal : mesh.normals) {
    tables.normal.push_back(normalized(draw.eye_normal_from_object * normal));
  }
  if (needs_face_normals(draw, settings)) {
    for (const Face& face : mesh.faces) {
      const std::optional<Normal<Object>> normal = face_normal(mesh, face);
      tables.face_normal.push_back(normal ? normalized(draw.eye_normal_from_object * *normal)
                                          : Normal<Eye>{});
    }
  }
  return tables;
}

std::vector<Point<Clip>> transform_other_eye(const Draw& other_eye,
                                             const std::vector<Point<Clip>>& first_eye,
                                             Observer* observer) {
  std::vector<Point<Clip>> clip = first_eye;
  for (std::size_t i = 0; i < clip.size(); ++i) {
    clip[i].x = transform_row(other_eye.clip_from_anchored, 0,
                              relative_to_anchor(other_eye, other_eye.mesh->positions[i]));
    if (observer != nullptr) observer->projected(other_eye, std::uint32_t(i), clip[i]);
  }
  return clip;
}

}  // namespace glassbox
