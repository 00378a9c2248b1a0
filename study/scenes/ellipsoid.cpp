#include "study/scenes/ellipsoid.h"

#include <algorithm>
#include <array>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox::study {

namespace {

constexpr std::array<double, 3> kAxes = {1.7, 1, 1};

void add_vertices(Mesh& mesh, const EllipsoidGrid& grid) {
  for (int s = 0; s <= grid.stacks; ++s) {
    const SinCos theta = sin_cos(kPi * s / grid.stacks);
    for (int l = 0; l <= grid.slices; ++l) {
      const SinCos phi = sin_cos(2 * kPi * l / grid.slices);
      const double x = kAxes[0] * theta.sin * phi.sin;
      const double y = kAxes[1] * theta.cos;
      const double z = kAxes[2] * theta.sin * phi.cos;
      add_position(mesh, x, y, z);
      add_normal(mesh,
                 {x / (kAxes[0] * kAxes[0]), y / (kAxes[1] * kAxes[1]), z / (kAxes[2] * kAxes[2])});
    }
  }
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  add_face(mesh, std::array<Corner, 3>{{{a, a}, {b, b}, {c, c}}});
}

// Adds one quad of the grid as two triangles; at the poles it is a single triangle.
void add_quad(Mesh& mesh, const EllipsoidGrid& grid, int s, int l) {
  const std::uint32_t row = std::uint32_t(grid.slices) + 1;
  const std::uint32_t a = std::uint32_t(s) * row + std::uint32_t(l), d = a + 1;
  const std::uint32_t b = a + row, c = b + 1;
  if (s != grid.stacks - 1) add_triangle(mesh, a, b, c);
  if (s != 0) add_triangle(mesh, a, c, d);
}

}  // namespace

Mesh make_ellipsoid(const EllipsoidGrid& grid) {
  Mesh mesh;
  mesh.name = "ellipsoid";
  const auto vertices = std::size_t(grid.stacks + 1) * std::size_t(grid.slices + 1);
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.faces.reserve(triangles_of(grid));
  mesh.corners.reserve(3 * triangles_of(grid));
  add_vertices(mesh, grid);
  const int band = grid.band > 0 ? grid.band : grid.slices;
  for (int first = 0; first < grid.slices; first += band) {
    const int last = std::min(first + band, grid.slices);
    for (int s = 0; s < grid.stacks; ++s) {
      for (int l = first; l < last; ++l) add_quad(mesh, grid, s, l);
    }
  }
  return mesh;
}

}  // namespace glassbox::study
