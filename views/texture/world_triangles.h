// A scene's triangles in world space.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/two_view/camera.h"

namespace glassbox::views {

struct WorldTriangle {
  std::array<Vector3d, 3> corners;  // world, counter-clockwise seen from its front
  // Its own colour: the mean of its corners' colours, as displayed.
  std::array<std::uint8_t, 3> color{};
  std::uint32_t number = 0;  // among the scene's triangles

  // The normal; its length is twice the triangle's area, so it is 0 for a triangle without area.
  Vector3d normal() const;
};

// The triangles that are drawn, in the order of drawing: their numbers ascend, with gaps for faces
// without area.
std::vector<WorldTriangle> world_triangles(const Scene& scene);

// Bytes that a scene's meshes occupy.
double bytes_of(const Scene& scene);

// How many numbers the triangles take, gaps included.
std::size_t triangle_number_count(const Scene& scene);

}  // namespace glassbox::views
