#include <glassbox/render/trace/corner_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glassbox/mesh/normals.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/light_formulas.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {
namespace {

using bounded::Bounded;
using bounded::BoundedOf;
using bounded::standing_for;
using Bounded3 = std::array<Bounded, 3>;

template <class Columns, class Bounds>
struct BoundedMatrix {
  const Columns& columns;
  const Bounds& bounds;
  Bounded at(int row, int column) const { return {columns[column][row], bounds[column][row]}; }
};
template <class Columns, class Bounds>
BoundedMatrix(const Columns&, const Bounds&) -> BoundedMatrix<Columns, Bounds>;

Bounded3 eye_position(const Draw& draw, const DrawBounds& bounds, const Point<Object>& object) {
  const BoundedMatrix matrix{draw.eye_from_anchored.columns, bounds.eye_from_anchored};
  const Bounded x = Bounded(object.x) - draw.anchor.x, y = Bounded(object.y) - draw.anchor.y,
                z = Bounded(object.z) - draw.anchor.z;
  Bounded3 eye;
  for (int row = 0; row < 3; ++row) {
    eye[std::size_t(row)] = bounded::transform_row(matrix, row, x, y, z);
  }
  return eye;
}

double largest_entry(const glm::dmat3& m) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  }
  return largest;
}

// Bounds the entries of Draw::eye_normal_from_object. eye_from_object is a product of matrices in
// double, one of them a rotation: its entries are accurate to 12 * 2^-53 of the largest one. A
// cofactor is a difference of two products of such entries, accurate to 51 * 2^-53 of the square of
// the largest. The scale makes the largest cofactor at most 1, and the rest is one rounding to
// float.
glm::dmat3 normal_matrix_bound(const Draw& draw) {
  const glm::dmat3 linear(draw.eye_from_object.columns);
  const double largest = largest_entry(linear);
  double cofactor = 0;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      const int c1 = (c + 1) % 3, c2 = (c + 2) % 3, r1 = (r + 1) % 3, r2 = (r + 2) % 3;
      cofactor =
          std::max(cofactor, std::abs(linear[c1][r1] / largest * (linear[c2][r2] / largest) -
                                      linear[c2][r1] / largest * (linear[c1][r2] / largest)));
    }
  }
  glm::dmat3 bound;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      bound[c][r] = std::abs(double(draw.eye_normal_from_object.columns[c][r])) * 0x1p-24 +
                    0x1p-47 / cofactor + 0x1p-150;
    }
  }
  return bound;
}

Bounded3 eye_normal(const Draw& draw, const Bounded3& object) {
  const glm::dmat3 bounds = normal_matrix_bound(draw);
  const BoundedMatrix matrix{draw.eye_normal_from_object.columns, bounds};
  Bounded3 eye;
  for (int row = 0; row < 3; ++row) {
    eye[std::size_t(row)] = bounded::transform_normal_row(matrix, row, object);
  }
  return bounded::unit_normal(eye);
}

// Newell's vector is a sum of products of differences, in double. Its error is gamma_(N+3) of the
// sum of the products' sizes.
Bounded3 eye_normal_of_face(const Draw& draw, const Face& face) {
  const std::optional<Normal<Object>> normal = face_normal(*draw.mesh, face);
  if (!normal) return {};
  std::vector<Point<Object, BoundedOf<double>>> corners;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const Point<Object>& p = draw.mesh->positions[draw.mesh->corners[face.first + i].position];
    corners.emplace_back(double(p.x), double(p.y), double(p.z));
  }
  const auto newell = newell_vector<BoundedOf<double>>(corners);
  const BoundedOf<double> length =
      bounded::sqrt(newell.x * newell.x + newell.y * newell.y + newell.z * newell.z);
  return eye_normal(draw, {standing_for(normal->x, bounded::rounded(newell.x / length)),
                           standing_for(normal->y, bounded::rounded(newell.y / length)),
                           standing_for(normal->z, bounded::rounded(newell.z / length))});
}

Bounded3 eye_centre(const Draw& draw, const DrawBounds& bounds, const Face& face) {
  Bounded3 sum{};
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const Corner& corner = draw.mesh->corners[face.first + i];
    sum = bounded::sum(sum, eye_position(draw, bounds, draw.mesh->positions[corner.position]));
  }
  const Bounded share = Bounded(1.0f) / float(face.count);
  return {sum[0] * share, sum[1] * share, sum[2] * share};
}

void light(const Draw& draw, const Lighting& lighting, const Bounded3& position,
           BoundedVaryings& vertex) {
  constexpr bool kHighlights = true;
  const auto reflection = bounded::reflected_light(lighting, position, vertex.normal,
                                                   draw.material->shininess, kHighlights);
  vertex.diffuse = reflection.diffuse;
  vertex.specular = reflection.specular;
}

// The attributes that do not depend on a face.
BoundedVaryings as_modelled(const CornerStage& stage, const Corner& corner) {
  const Mesh& mesh = *stage.draw.mesh;
  BoundedVaryings at;
  if (corner.texcoord != kNone) {
    at.texcoord = {mesh.texcoords[corner.texcoord].u, mesh.texcoords[corner.texcoord].v};
  }
  if (corner.color != kNone) {
    const Rgba& color = mesh.colors[corner.color];
    at.color = {color.r, color.g, color.b, color.a};
  }
  if (!needs_normals(stage.draw, stage.settings)) return at;
  at.position = eye_position(stage.draw, stage.bounds, mesh.positions[corner.position]);
  if (corner.normal != kNone) {
    const Normal<Object>& normal = mesh.normals[corner.normal];
    at.normal = eye_normal(stage.draw, {normal.x, normal.y, normal.z});
  }
  return at;
}

template <std::size_t N>
std::array<Bounded, N> weigh(const std::array<Bounded, N>& a, const std::array<Bounded, N>& b,
                             const std::array<Bounded, N>& c,
                             const std::array<BoundedOf<double>, 3>& weights) {
  std::array<Bounded, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] =
        bounded::rounded(weights[0] * bounded::widened(a[i]) + weights[1] * bounded::widened(b[i]) +
                         weights[2] * bounded::widened(c[i]));
  }
  return result;
}

}  // namespace

BoundedVaryings corner_of_line(const CornerStage& stage, const Corner& corner) {
  return as_modelled(stage, corner);
}

BoundedVaryings corner_of_face(const CornerStage& stage, const Face& face, const Corner& corner,
                               bool front) {
  BoundedVaryings at = as_modelled(stage, corner);
  if (!needs_normals(stage.draw, stage.settings)) return at;
  const bool flat = stage.settings.shading == Shading::kFlat;
  if (flat || corner.normal == kNone) at.normal = eye_normal_of_face(stage.draw, face);
  if (!front) at.normal = {-at.normal[0], -at.normal[1], -at.normal[2]};
  if (flat) {
    light(stage.draw, stage.lighting, eye_centre(stage.draw, stage.bounds, face), at);
  }
  if (stage.settings.shading == Shading::kGouraud) {
    light(stage.draw, stage.lighting, at.position, at);
  }
  return at;
}

BoundedVaryings at_vertex(const std::array<BoundedVaryings, 3>& corners, const ClipVertex& vertex,
                          const ClipVertexBound& bound) {
  std::array<BoundedOf<double>, 3> weights;
  for (std::size_t k = 0; k < 3; ++k) {
    weights[k] = {vertex.weights[k], bound.weights[int(k)]};
    if (vertex.weights[k] == 1 && bound.weights == glm::dvec3(0)) return corners[k];
  }
  return combine(corners, [&](const auto& a, const auto& b, const auto& c) {
    return weigh(a, b, c, weights);
  });
}

}  // namespace glassbox
