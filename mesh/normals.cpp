#include <glassbox/mesh/normals.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace glassbox {
namespace {

Point<Object, double> corner_position(const Mesh& mesh, const Face& face, std::uint32_t i) {
  const Point<Object>& p = mesh.positions[mesh.corners[face.first + i].position];
  return {p.x, p.y, p.z};
}

std::vector<Point<Object, double>> outline(const Mesh& mesh, const Face& face) {
  std::vector<Point<Object, double>> points;
  points.reserve(face.count);
  for (std::uint32_t i = 0; i < face.count; ++i) points.push_back(corner_position(mesh, face, i));
  return points;
}

// The vector v scaled to unit length; absent if v has no direction. Dividing by the largest
// component first prevents the squares from overflowing or underflowing.
std::optional<Vector<Object, double>> direction(const Vector<Object, double>& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  const Vector<Object, double> scaled(v.x / largest, v.y / largest, v.z / largest);
  const double length = std::sqrt(dot(scaled, scaled));
  if (!std::isfinite(length)) return std::nullopt;
  return Vector<Object, double>(scaled.x / length, scaled.y / length, scaled.z / length);
}

}  // namespace

std::optional<Normal<Object>> unit_normal(const Vector<Object, double>& v) {
  const auto unit = direction(v);
  if (!unit) return std::nullopt;
  return Normal<Object>(float(unit->x), float(unit->y), float(unit->z));
}

Vector<Object, double> newell_vector(const Mesh& mesh, const Face& face) {
  // Triangles, by far the most frequent faces, need no list.
  if (face.count == 3) {
    const std::array<Point<Object, double>, 3> points = {corner_position(mesh, face, 0),
                                                         corner_position(mesh, face, 1),
                                                         corner_position(mesh, face, 2)};
    return newell_vector<double>(std::span<const Point<Object, double>>(points));
  }
  const std::vector<Point<Object, double>> points = outline(mesh, face);
  return newell_vector<double>(std::span<const Point<Object, double>>(points));
}

std::optional<Normal<Object>> face_normal(const Mesh& mesh, const Face& face) {
  return unit_normal(newell_vector(mesh, face));
}

double face_area(const Mesh& mesh, const Face& face) {
  const Vector<Object, double> m = newell_vector(mesh, face);
  return 0.5 * std::sqrt(dot(m, m));
}

double planarity_deviation(const Mesh& mesh, const Face& face) {
  if (face.count <= 3) return 0;
  const auto normal = direction(newell_vector(mesh, face));
  if (!normal) return 0;
  const Point<Object, double> origin = corner_position(mesh, face, 0);
  std::vector<double> heights;
  heights.reserve(face.count);
  double sum = 0;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    heights.push_back(dot(*normal, corner_position(mesh, face, i) - origin));
    sum += heights.back();
  }
  const double mean = sum / double(face.count);
  double deviation = 0;
  for (const double height : heights) deviation = std::max(deviation, std::abs(height - mean));
  return deviation;
}

}  // namespace glassbox
