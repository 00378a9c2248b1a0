// Where a triangle's number in the whole scene leads.
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

// How many numbers there are, those of triangles without area included.
std::uint64_t count_triangles(const Scene& scene);

// Nothing where there is no such number.
std::optional<NumberedTriangle> find_triangle(const Scene& scene, std::uint64_t number);

}  // namespace glassbox
