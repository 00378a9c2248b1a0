// A scene's triangles where they stand in the world.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/two_view/camera.h"

namespace glassbox::views {

struct PlacedTriangle {
  std::array<Vector3d, 3> corners;      // world, counter-clockwise seen from its front
  std::array<std::uint8_t, 3> color{};  // its own: the mean of its corners', as displayed
  std::uint32_t number = 0;             // of the scene's triangles

  // On which it stands, as long as twice its area; 0 of one without area.
  Vector3d normal() const;
};

// Those that are drawn, in the order in which they are: numbers ascend, and faces without area leave gaps.
std::vector<PlacedTriangle> placed_triangles(const Scene& scene);

// What a scene's meshes take.
double bytes_of(const Scene& scene);

// The numbers taken, gaps included.
std::size_t numbers_of(const Scene& scene);

}  // namespace glassbox::views
