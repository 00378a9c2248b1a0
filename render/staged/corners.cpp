#include <glassbox/render/staged/corners.h>

#include <cstddef>

#include <glassbox/raster/interpolate.h>

namespace glassbox {

namespace {

std::array<float, 3> components(const Point<Eye>& p) {
  return {p.x, p.y, p.z};
}
std::array<float, 3> components(const Normal<Eye>& n) {
  return {n.x, n.y, n.z};
}
std::array<float, 3> negated(const std::array<float, 3>& v) {
  return {-v[0], -v[1], -v[2]};
}

Outcode outcode_of(const PrimitiveStage& stage, const ClipVertex& vertex, std::uint32_t index) {
  return stage.clip != nullptr ? stage.clip->outcodes[index]
                               : outcode(vertex.position, stage.planes);
}

std::array<float, 3> centre_of_face(const PrimitiveStage& stage, const Face& face) {
  std::array<float, 3> sum{};
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const Corner& corner = stage.draw.mesh->corners[face.first + i];
    const Point<Eye>& p = stage.eye_space.positions[corner.position];
    sum = {sum[0] + p.x, sum[1] + p.y, sum[2] + p.z};
  }
  const float share = 1.0f / float(face.count);
  return {sum[0] * share, sum[1] * share, sum[2] * share};
}

void light(const PrimitiveStage& stage, const std::array<float, 3>& position, Varyings& vertex) {
  const Reflection reflection =
      illuminate(stage.lighting, position, vertex.normal, stage.draw.material->shininess);
  vertex.diffuse = reflection.diffuse;
  vertex.specular = reflection.specular;
}

std::array<Varyings, 3> triangle_attributes(const PrimitiveStage& stage, const Triangle& triangle,
                                            bool front) {
  const Mesh& mesh = *stage.draw.mesh;
  const Face& face = mesh.faces[triangle.face];
  const bool lit = stage.eye_space.lit;
  const bool flat = stage.settings.shading == Shading::kFlat;

  std::array<Varyings, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& corner = mesh.corners[triangle.corners[k]];
    vertices[k] = corner_attributes(stage, corner);
    if (!lit) continue;
    if (flat || corner.normal == kNone) {
      vertices[k].normal = components(stage.eye_space.face_normals[triangle.face]);
    }
    if (!front) vertices[k].normal = negated(vertices[k].normal);
    if (flat) light(stage, centre_of_face(stage, face), vertices[k]);
    if (stage.settings.shading == Shading::kGouraud)
      light(stage, vertices[k].position, vertices[k]);
  }
  return vertices;
}

template <std::size_t N>
std::array<float, N> weigh(const std::array<float, N>& a, const std::array<float, N>& b,
                           const std::array<float, N>& c, const std::array<double, 3>& weights) {
  std::array<float, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] =
        float(weights[0] * double(a[i]) + weights[1] * double(b[i]) + weights[2] * double(c[i]));
  }
  return result;
}

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
  const Mesh& mesh = *stage.draw.mesh;
  Varyings varyings;
  if (corner.texcoord != kNone) {
    varyings.texcoord = {mesh.texcoords[corner.texcoord].u, mesh.texcoords[corner.texcoord].v};
  }
  if (corner.color != kNone) {
    const Rgba& color = mesh.colors[corner.color];
    varyings.color = {color.r, color.g, color.b, color.a};
  }
  if (!stage.eye_space.positions.empty()) {
    varyings.position = components(stage.eye_space.positions[corner.position]);
  }
  if (corner.normal != kNone && !stage.eye_space.normals.empty()) {
    varyings.normal = components(stage.eye_space.normals[corner.normal]);
  }
  return varyings;
}

const std::array<Varyings, 3>& attributes_of(const PrimitiveStage& stage, const Triangle& triangle,
                                             bool front, TriangleAttributes& attributes) {
  std::optional<std::array<Varyings, 3>>& side = front ? attributes.front : attributes.back;
  if (!side) side = triangle_attributes(stage, triangle, front);
  return *side;
}

Varyings attributes_at(const std::array<Varyings, 3>& corners,
                       const std::array<double, 3>& weights) {
  // Most vertices are corners that clipping did not change. The weighted sum would give back their
  // attributes, except for the sign of a zero, which no later stage uses.
  if (weights[1] == 0 && weights[2] == 0) return corners[0];
  if (weights[2] == 0 && weights[0] == 0) return corners[1];
  if (weights[0] == 0 && weights[1] == 0) return corners[2];
  return combine(corners, [&](const auto& a, const auto& b, const auto& c) {
    return weigh(a, b, c, weights);
  });
}

}  // namespace glassbox
