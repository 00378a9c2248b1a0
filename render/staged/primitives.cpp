#include <glassbox/render/staged/primitives.h>

#include <cstddef>
#include <optional>
#include <span>

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>

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

ScreenVertex vertex_on_screen(const PrimitiveStage& stage, const ClipVertex& vertex) {
  NdcVertex ndc = divide(vertex);
  if (stage.observer != nullptr) stage.observer->divided(vertex, ndc);
  ScreenVertex screen = to_screen(ndc, stage.view.viewport);
  if (stage.observer != nullptr) stage.observer->placed(ndc, screen);
  return screen;
}

// A clipped polygon on the screen, cut into a fan of triangles.
struct ScreenPolygon {
  std::array<ScreenVertex, kMaxClipVertices> vertices;
  int count = 0;
  int apex = 0;
};

ScreenPolygon polygon_on_screen(const PrimitiveStage& stage, const ClipPolygon& polygon) {
  ScreenPolygon screen;
  screen.count = polygon.count;
  std::array<SnappedVertex, kMaxClipVertices> snapped;
  const std::size_t count = std::size_t(polygon.count);
  for (std::size_t k = 0; k < count; ++k) {
    screen.vertices[k] = vertex_on_screen(stage, polygon.vertices[k]);
    snapped[k] = snap(screen.vertices[k]);
  }
  if (count > 3) screen.apex = fan_apex(std::span(snapped).first(count));
  return screen;
}

// ---- clipping ----

Point<Clip> clip_position(const PrimitiveStage& stage, std::uint32_t index) {
  return stage.clip != nullptr ? stage.clip->positions[index] : project_vertex(stage.draw, index);
}

Outcode outcode_of(const PrimitiveStage& stage, const ClipVertex& vertex, std::uint32_t index) {
  return stage.clip != nullptr ? stage.clip->outcodes[index]
                               : outcode(vertex.position, stage.planes);
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

// What the view's planes leave of a triangle; most are left whole, or nothing of them.
ClipPolygon clip_to_view(const PrimitiveStage& stage, const std::array<ClipVertex, 3>& corners,
                         const std::array<Outcode, 3>& codes) {
  switch (trivial_verdict(codes)) {
    case ClipVerdict::kAccept:
      return {{corners[0], corners[1], corners[2]}, 3};
    case ClipVerdict::kReject:
      ++stage.statistics.rejected;
      return {};
    case ClipVerdict::kClip:
      break;
  }
  const ClipPolygon polygon = clip_triangle(corners, stage.planes);
  ++(polygon.count == 0 ? stage.statistics.clipped_away : stage.statistics.clipped);
  return polygon;
}

// ---- facing ----

// Turned away for certain, which is known before anything is clipped. What a plane cuts is left to the snapped area.
bool is_culled_early(const PrimitiveStage& stage, const Triangle& triangle,
                     const std::array<Outcode, 3>& codes) {
  if (!stage.object_cull || trivial_verdict(codes) != ClipVerdict::kAccept) return false;
  const Mesh& mesh = *stage.draw.mesh;
  const auto corner = [&](std::size_t k) {
    return mesh.positions[mesh.corners[triangle.corners[k]].position];
  };
  return stage.object_cull->removes({corner(0), corner(1), corner(2)});
}

// Counter-clockwise in the world is counter-clockwise on the screen: the eye sees what a person there would see. A
// mirroring model matrix turns the winding round, and the outside with it.
bool shows_front(const PrimitiveStage& stage, const TriangleSetup& setup) {
  return setup.clockwise == stage.draw.mirrored;
}

struct Visible {
  TriangleSetup setup;
  bool front = true;
};

// A piece of a polygon, set up; nothing where it has no area on the screen or is culled.
std::optional<Visible> setup_visible(const PrimitiveStage& stage, const ScreenPolygon& screen,
                                     int number, const std::array<std::size_t, 3>& piece) {
  ++stage.statistics.after_clipping;
  const std::array<ScreenVertex, 3> vertices{screen.vertices[piece[0]], screen.vertices[piece[1]],
                                             screen.vertices[piece[2]]};
  std::optional<TriangleSetup> setup = setup_triangle(vertices);
  if (stage.observer != nullptr) stage.observer->set_up(std::uint32_t(number), vertices, setup);
  if (!setup) {
    ++stage.statistics.zero_area;
    return std::nullopt;
  }
  const bool front = shows_front(stage, *setup);
  bool culled = is_culled(stage.draw, stage.settings.cull, front);
  if (stage.observer != nullptr) stage.observer->faced(*setup, front, culled);
  if (culled) {
    ++stage.statistics.culled;
    return std::nullopt;
  }
  ++stage.statistics.set_up;
  return Visible{*setup, front};
}

// ---- attributes ----

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

// Everything but the lighting.
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

void light(const PrimitiveStage& stage, const std::array<float, 3>& position, Varyings& vertex) {
  const Reflection reflection =
      illuminate(stage.lighting, position, vertex.normal, stage.draw.material->shininess);
  vertex.diffuse = reflection.diffuse;
  vertex.specular = reflection.specular;
}

// The three corners as the fragments will interpolate them, lit where the shading is per face or per vertex. Seen from
// behind, a surface is lit as if its normals pointed the other way.
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

const std::array<Varyings, 3>& attributes_of(const PrimitiveStage& stage, const Triangle& triangle,
                                             bool front, TriangleAttributes& attributes) {
  std::optional<std::array<Varyings, 3>>& side = front ? attributes.front : attributes.back;
  if (!side) side = triangle_attributes(stage, triangle, front);
  return *side;
}

// The attributes at a vertex that clipping made, from the corners of the primitive as it came.
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

Varyings attributes_at(const std::array<Varyings, 3>& corners,
                       const std::array<double, 3>& weights) {
  // Most vertices are corners that clipping has left alone: weighing would give back what they have, but for the sign of
  // a zero, which nothing further on reads.
  if (weights[1] == 0 && weights[2] == 0) return corners[0];
  if (weights[2] == 0 && weights[0] == 0) return corners[1];
  if (weights[0] == 0 && weights[1] == 0) return corners[2];
  return combine(corners, [&](const auto& a, const auto& b, const auto& c) {
    return weigh(a, b, c, weights);
  });
}

// ---- lines ----

void ready_segment(const PrimitiveStage& stage, const std::array<ClipVertex, 2>& ends,
                   const std::array<Varyings, 3>& corners, std::uint32_t id,
                   std::vector<ReadyLine>& lines) {
  const std::optional<std::array<ClipVertex, 2>> kept = clip_segment(ends, stage.planes);
  if (!kept) return;
  lines.push_back(
      {{vertex_on_screen(stage, (*kept)[0]), vertex_on_screen(stage, (*kept)[1])},
       {attributes_at(corners, (*kept)[0].weights), attributes_at(corners, (*kept)[1].weights)},
       id});
}

}  // namespace

void ready_triangle(const PrimitiveStage& stage, const Triangle& triangle,
                    TriangleAttributes& attributes, std::vector<ReadyTriangle>& triangles,
                    std::vector<ReadyLine>& lines) {
  const std::array<ClipVertex, 3> corners = clip_vertices(stage, triangle);
  const std::array<Outcode, 3> codes = outcodes_of(stage, triangle, corners);
  if (is_culled_early(stage, triangle, codes)) {
    ++stage.statistics.culled_early;
    return;
  }
  ClipPolygon polygon = clip_to_view(stage, corners, codes);
  if (stage.observer != nullptr) stage.observer->clipped(stage, triangle, corners, polygon);
  const ScreenPolygon screen = polygon_on_screen(stage, polygon);
  const std::uint32_t number = stage.draw.first_number + triangle.number;

  const std::array<Varyings, 3>* visible_corners = nullptr;
  for (int i = 0; i < fan_size(polygon); ++i) {
    const std::array<std::size_t, 3> piece = fan_vertices(screen.apex, screen.count, i);
    const std::optional<Visible> visible = setup_visible(stage, screen, i, piece);
    if (!visible) continue;
    if (visible_corners == nullptr) {
      visible_corners = &attributes_of(stage, triangle, visible->front, attributes);
    }
    if (stage.settings.wireframe) break;

    ReadyTriangle ready{visible->setup, {}, number, std::uint32_t(i)};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = piece[std::size_t(visible->setup.order[k])];
      ready.vertices[k] = attributes_at(*visible_corners, polygon.vertices[vertex].weights);
    }
    triangles.push_back(ready);
  }

  if (stage.settings.wireframe && visible_corners != nullptr) {
    for (std::size_t k = 0; k < 3; ++k) {
      ready_segment(stage, {corners[k], corners[(k + 1) % 3]}, *visible_corners, number + 1, lines);
    }
  }
  if (stage.observer != nullptr) stage.observer->prepared(triangle);
}

void ready_line(const PrimitiveStage& stage, const std::array<Corner, 2>& line,
                std::vector<ReadyLine>& lines) {
  std::array<ClipVertex, 2> ends;
  std::array<Varyings, 3> vertices;
  for (std::size_t k = 0; k < 2; ++k) {
    ends[k].position = clip_position(stage, line[k].position);
    ends[k].weights[k] = 1.0;
    vertices[k] = corner_attributes(stage, line[k]);
  }
  ready_segment(stage, ends, vertices, 0, lines);
}

void ready_point(const PrimitiveStage& stage, const Corner& point,
                 std::vector<ReadyPoint>& points) {
  ClipVertex vertex;
  vertex.position = clip_position(stage, point.position);
  if (!clip_point(vertex.position, stage.planes)) return;
  points.push_back({vertex_on_screen(stage, vertex), corner_attributes(stage, point)});
}

}  // namespace glassbox
