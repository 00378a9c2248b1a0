// Polygons, meshes with a single face, and exact Newell vectors in rational numbers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/mesh/mesh.h>
#include <glassbox/mesh/normals.h>

#include "exact/number.h"

namespace glassbox::study {

using Polygon = std::vector<Point<Object>>;
using PolygonNormal = Vector<Object, double> (*)(std::span<const Point<Object>>);

inline Mesh mesh_of(const Polygon& positions, const std::vector<std::uint32_t>& indices) {
  Mesh mesh;
  mesh.positions = positions;
  mesh.faces.push_back({0, std::uint32_t(indices.size())});
  for (const std::uint32_t i : indices) mesh.corners.push_back({i, kNone, kNone, kNone});
  return mesh;
}

// A mesh with one face that uses all positions in their order.
inline Mesh mesh_of(const Polygon& positions) {
  std::vector<std::uint32_t> all(positions.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return mesh_of(positions, all);
}

// The pipeline's own Newell vector.
inline Vector<Object, double> newell_in_double(std::span<const Point<Object>> polygon) {
  const Mesh mesh = mesh_of({polygon.begin(), polygon.end()});
  return newell_vector(mesh, mesh.faces[0]);
}

// Newell's sums by the pipeline's own code, but in rational numbers.
inline Vector<Object, exact::Rational> exact_newell(std::span<const Point<Object>> polygon) {
  std::vector<Point<Object, exact::Rational>> exact;
  for (const Point<Object>& p : polygon) {
    exact.emplace_back(exact::Rational(double(p.x)), exact::Rational(double(p.y)),
                       exact::Rational(double(p.z)));
  }
  return newell_vector<exact::Rational>(exact);
}

// The angle between a vector and an exact one; pi/2 if the vector has no direction.
double angle_to(const Vector<Object, double>& v, const Vector<Object, exact::Rational>& exact);

}  // namespace glassbox::study
