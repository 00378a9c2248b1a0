#include <glassbox/render/trace/corner_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glassbox/mesh/normals.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {
namespace {

using bounded::Bounded;
using bounded::BoundedOf;
using bounded::with_bound_from;
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
// cofactor is a difference of two products of such entries, so it is accurate to 51 * 2^-53 of the
// square of the largest entry: 12 for each of the four factors and 3 roundings. This is below
// 2^-47. The matrix is then scaled so that its largest cofactor is at most 1, which divides the
// error by that cofactor. The last error is one rounding to float.
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

// The Newell vector of a face with N corners is a sum of products of differences, in double. Its
// error is at most gamma(N + 3) times the sum of the absolute values of the products, where
// gamma(n) = n u / (1 - n u) with the unit roundoff u = 2^-53.
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
  return eye_normal(draw, {with_bound_from(normal->x, bounded::rounded(newell.x / length)),
                           with_bound_from(normal->y, bounded::rounded(newell.y / length)),
                           with_bound_from(normal->z, bounded::rounded(newell.z / length))});
}

// The attributes of a draw's vertices with bounds, with the members that formulas/corners.h needs.
struct BoundedTables {
  using Float = Bounded;
  const CornerStage& stage;

  const Mesh& mesh() const { return *stage.draw.mesh; }
  bool has_positions() const { return is_lit(); }
  Bounded3 position(std::uint32_t index) const {
    return eye_position(stage.draw, stage.bounds, mesh().positions[index]);
  }
  bool has_normals() const { return is_lit(); }
  Bounded3 normal(std::uint32_t index) const {
    const Normal<Object>& normal = mesh().normals[index];
    return eye_normal(stage.draw, {normal.x, normal.y, normal.z});
  }
  Bounded3 face_normal(std::uint32_t face) const {
    return eye_normal_of_face(stage.draw, mesh().faces[face]);
  }

  bool is_lit() const { return needs_normals(stage.draw, stage.settings); }
  bool is_lit_by_face() const { return stage.settings.shading == Shading::kFlat; }
  bool is_lit_by_vertex() const { return stage.settings.shading == Shading::kGouraud; }
  const Lighting& lighting() const { return stage.lighting; }
  int shininess() const { return stage.draw.material->shininess; }

  struct FaceCorners {
    using Float = Bounded;
    const BoundedTables& tables;
    const Face& face;
    bounded::UncertainBool has(std::int32_t k) const { return {std::uint32_t(k) < face.count}; }
    Bounded3 position(std::int32_t k) const {
      return tables.position(tables.mesh().corners[face.first + std::uint32_t(k)].position);
    }
    Bounded count() const { return float(face.count); }
  };
  FaceCorners corners(std::uint32_t face) const { return {*this, mesh().faces[face]}; }
};

}  // namespace

BoundedVaryings corner_of_line(const CornerStage& stage, const Corner& corner) {
  return bounded::modelled_corner_attributes(BoundedTables{stage}, corner);
}

BoundedVaryings face_corner_attributes(const CornerStage& stage, std::uint32_t face,
                                       const Corner& corner, bool front) {
  return bounded::face_corner_attributes(BoundedTables{stage}, face, corner, front);
}

BoundedVaryings at_vertex(const std::array<BoundedVaryings, 3>& corners, const ClipVertex& vertex,
                          const ClipVertexBound& bound) {
  std::array<BoundedOf<double>, 3> weights;
  for (std::size_t k = 0; k < 3; ++k) weights[k] = {vertex.weights[k], bound.weights[int(k)]};
  return bounded::clipped_vertex_attributes(corners, weights);
}

}  // namespace glassbox
