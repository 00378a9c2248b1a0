#include <glassbox/mesh/newell_sums.h>

#include <cmath>
#include <cstdint>

namespace glassbox {

namespace {

Point<Object, double> corner_at(const Mesh& mesh, const Face& face, std::uint32_t i) {
  const Point<Object>& p = mesh.positions[mesh.corners[face.first + i % face.count].position];
  return {p.x, p.y, p.z};
}

}  // namespace

std::vector<NewellRow> newell_rows(const Mesh& mesh, const Face& face) {
  std::vector<NewellRow> rows;
  rows.reserve(face.count);
  Vector<Object, double> sums(0, 0, 0);
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const Point<Object, double> a = corner_at(mesh, face, i), b = corner_at(mesh, face, i + 1);
    const Vector<Object, double> terms((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x),
                                       (a.x - b.x) * (a.y + b.y));
    sums = sums + terms;
    rows.push_back({terms, sums});
  }
  return rows;
}

Vector<Object, double> newell_error_bound(const std::vector<NewellRow>& rows) {
  Vector<Object, double> sizes(0, 0, 0);
  for (const NewellRow& row : rows) {
    sizes.x += std::abs(row.terms.x);
    sizes.y += std::abs(row.terms.y);
    sizes.z += std::abs(row.terms.z);
  }
  return sizes * (double(rows.size() + 3) * 0x1.001p-53);
}

}  // namespace glassbox
