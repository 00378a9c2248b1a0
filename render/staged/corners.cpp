#include <glassbox/render/staged/corners.h>

#include <cstddef>

#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/light_formulas.h>

namespace glassbox {

namespace {

std::array<float, 3> components(const Point<Eye>& p) {
  return {p.x, p.y, p.z};
}
std::array<float, 3> components(const Normal<Eye>& n) {
  return {n.x, n.y, n.z};
}

Outcode outcode_of(const PrimitiveStage& stage, const ClipVertex& vertex, std::uint32_t index) {
  return stage.clip != nullptr ? stage.clip->outcodes[index]
                               : outcode(vertex.position, stage.planes);
}

// The vertex stage's results for a draw, with the members that formulas/corners.h needs.
struct CornerTables {
  using Float = float;
  const PrimitiveStage& stage;

  const Mesh& mesh() const { return *stage.draw.mesh; }
  bool has_positions() const { return !stage.eye_space.positions.empty(); }
  std::array<float, 3> position(std::uint32_t index) const {
    return components(stage.eye_space.positions[index]);
  }
  bool has_normals() const { return !stage.eye_space.normals.empty(); }
  std::array<float, 3> normal(std::uint32_t index) const {
    return components(stage.eye_space.normals[index]);
  }
  std::array<float, 3> face_normal(std::uint32_t face) const {
    return components(stage.eye_space.face_normals[face]);
  }

  bool is_lit() const { return stage.eye_space.lit; }
  bool is_lit_by_face() const { return stage.settings.shading == Shading::kFlat; }
  bool is_lit_by_vertex() const { return stage.settings.shading == Shading::kGouraud; }
  const Lighting& lighting() const { return stage.lighting; }
  int shininess() const { return stage.draw.material->shininess; }

  struct FaceCorners {
    using Float = float;
    const CornerTables& tables;
    const Face& face;
    bool has(std::int32_t k) const { return std::uint32_t(k) < face.count; }
    std::array<float, 3> position(std::int32_t k) const {
      return tables.position(tables.mesh().corners[face.first + std::uint32_t(k)].position);
    }
    float count() const { return float(face.count); }
  };
  FaceCorners corners(std::uint32_t face) const { return {*this, mesh().faces[face]}; }
};

}  // namespace

Point<Clip> clip_position(const PrimitiveStage& stage, std::uint32_t index) {
  return stage.clip != nullptr ? stage.clip->positions[index] : project_vertex(stage.draw, index);
}

std::array<ClipVertex, 3> clip_vertices(const PrimitiveStage& stage, const Triangle& triangle) {
  std::array<ClipVertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& corner = stage.draw.mesh->corners[triangle.corners[k]];
    corners[k].position = clip_position(stage, corner.position);
    corners[k].weights[k] = 1.0;
  }
  return corners;
}

std::array<Outcode, 3> outcodes_of(const PrimitiveStage& stage, const Triangle& triangle,
                                   const std::array<ClipVertex, 3>& corners) {
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) {
    codes[k] =
        outcode_of(stage, corners[k], stage.draw.mesh->corners[triangle.corners[k]].position);
  }
  return codes;
}

ClipPolygon clip_to_view(const PrimitiveStage& stage, const std::array<ClipVertex, 3>& corners,
                         ClipVerdict verdict) {
  switch (verdict) {
    case ClipVerdict::kAccept:
      return {{corners[0], corners[1], corners[2]}, 3};
    case ClipVerdict::kReject:
      return {};
    case ClipVerdict::kClip:
      break;
  }
  return clip_triangle(corners, stage.planes);
}

bool is_culled_early(const PrimitiveStage& stage, const Triangle& triangle, ClipVerdict verdict) {
  if (!stage.object_cull || verdict != ClipVerdict::kAccept) return false;
  const Mesh& mesh = *stage.draw.mesh;
  const auto corner = [&](std::size_t k) {
    return mesh.positions[mesh.corners[triangle.corners[k]].position];
  };
  return stage.object_cull->removes({corner(0), corner(1), corner(2)});
}

Varyings corner_attributes(const PrimitiveStage& stage, const Corner& corner) {
  return modelled_corner_attributes(CornerTables{stage}, corner);
}

std::array<Varyings, 3> triangle_attributes(const PrimitiveStage& stage, const Triangle& triangle,
                                            bool front) {
  const CornerTables tables{stage};
  std::array<Varyings, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& corner = tables.mesh().corners[triangle.corners[k]];
    vertices[k] = face_corner_attributes(tables, triangle.face, corner, front);
  }
  return vertices;
}

Varyings attributes_at(const std::array<Varyings, 3>& corners,
                       const std::array<double, 3>& weights) {
  return clipped_vertex_attributes(corners, weights);
}

}  // namespace glassbox
