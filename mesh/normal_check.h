// Compares the normals of a mesh with the faces' own.
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include <glassbox/mesh/mesh.h>

namespace glassbox {

struct NormalReport {
  std::uint32_t corners = 0;        // of faces with an area, that have a normal
  std::uint32_t against_faces = 0;  // whose normal points to the back of their face
  // The mean angle between a corner's normal and the mean normal of the faces that meet there.
  double degrees_off = 0;
  // If the normals fit the faces after their coordinates are divided by the squares of these
  // factors: the factors, the smallest being 1. The mesh was probably scaled by them, and its
  // normals were multiplied by the same matrix instead of its inverse transpose (C-16).
  std::optional<glm::dvec3> scaled_by;

  // Whether the normals as a whole point to the backs.
  bool inverted() const { return 2 * against_faces > corners; }
};

// Takes O(n log n) in the number of corners. Only scales along the axes of the object's own space
// are found.
NormalReport normal_report(const Mesh& mesh);

}  // namespace glassbox
