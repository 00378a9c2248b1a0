// Finds the instance and face of a triangle by its number in the whole scene.
#pragma once

#include <cstdint>
#include <optional>

#include <glassbox/mesh/scene.h>

namespace glassbox {

struct NumberedTriangle {
  std::uint32_t number = 0;    // in the whole scene, from 0
  std::uint32_t instance = 0;  // index into Scene::instances
  std::uint32_t face = 0;      // index into Mesh::faces
};

// Returns how many triangle numbers the scene has; triangles without area are included.
std::uint64_t count_triangles(const Scene& scene);

// Returns how many of these numbers one instance has (an index into Scene::instances).
std::uint64_t count_triangles(const Scene& scene, std::uint32_t instance);

// Returns the triangle with this number; nothing if there is none.
std::optional<NumberedTriangle> find_triangle(const Scene& scene, std::uint64_t number);

}  // namespace glassbox
