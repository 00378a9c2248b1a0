// Small meshes for tests, and exact arithmetic to check results with.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <initializer_list>
#include <vector>

#include <glassbox/mesh/mesh.h>

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;
using ExactPoint = Point<Object, Rational>;
using ExactVector = Vector<Object, Rational>;
using Indices = std::vector<std::uint32_t>;

inline void add_polygon(Mesh& mesh, const Indices& positions) {
  mesh.faces.push_back({std::uint32_t(mesh.corners.size()), std::uint32_t(positions.size())});
  for (const std::uint32_t p : positions) mesh.corners.push_back({p, kNone, kNone, kNone});
}

inline Mesh make_mesh(std::vector<Point<Object>> positions, const std::vector<Indices>& faces) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  for (const Indices& face : faces) add_polygon(mesh, face);
  return mesh;
}

// A mesh of one face whose corners are all positions, in order.
inline Mesh make_polygon(std::vector<Point<Object>> positions) {
  Indices all(positions.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return make_mesh(std::move(positions), {all});
}

inline ExactPoint exact(const Point<Object>& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

inline std::vector<ExactPoint> exact(const std::vector<Point<Object>>& points) {
  std::vector<ExactPoint> result;
  for (const Point<Object>& p : points) result.push_back(exact(p));
  return result;
}

inline Vector<Object, double> rounded(const ExactVector& v) {
  return {v.x.convert_to<double>(), v.y.convert_to<double>(), v.z.convert_to<double>()};
}

}  // namespace glassbox::test
