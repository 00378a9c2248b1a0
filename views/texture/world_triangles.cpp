#include "views/texture/world_triangles.h"

#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <glassbox/images/srgb.h>
#include <glassbox/mesh/triangulate.h>

namespace glassbox::views {

namespace {

Eigen::Matrix<double, 3, 4> world_from(const Node& node) {
  Eigen::Matrix<double, 3, 4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column)
      matrix(row, column) = double(node.world_from_node.at(row, column));
  }
  return matrix;
}

}  // namespace

Vector3d WorldTriangle::normal() const {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

std::vector<WorldTriangle> world_triangles(const Scene& scene) {
  std::vector<WorldTriangle> all;
  all.reserve(triangle_number_count(scene));
  std::uint32_t first = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const auto world_from_node = world_from(scene.nodes[instance.node]);
    // A mirrored node reverses the winding of its triangles.
    const bool is_mirrored = world_from_node.leftCols<3>().determinant() < 0;
    const Rgba& base = scene.materials[mesh.material].base_color;
    const Triangulation triangulation = triangulate(mesh);
    for (const Triangle& triangle : triangulation.triangles) {
      WorldTriangle placed;
      placed.number = first + triangle.number;
      std::array<float, 3> light{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& corner = mesh.corners[triangle.corners[k]];
        const auto& p = mesh.positions[corner.position];
        placed.corners[k] =
            world_from_node * Eigen::Vector4d(double(p.x), double(p.y), double(p.z), 1);
        const Rgba own = corner.color == kNone ? Rgba{} : mesh.colors[corner.color];
        light = {light[0] + own.r * base.r / 3, light[1] + own.g * base.g / 3,
                 light[2] + own.b * base.b / 3};
      }
      if (is_mirrored) std::swap(placed.corners[1], placed.corners[2]);
      for (std::size_t c = 0; c < 3; ++c) placed.color[c] = encode_srgb(light[c]);
      all.push_back(placed);
    }
    first += triangulation.numbered;
  }
  return all;
}

double bytes_of(const Scene& scene) {
  const auto bytes = [](const auto& all) { return double(all.size() * sizeof(all[0])); };
  double sum = 0;
  for (const Mesh& mesh : scene.meshes)
    sum += bytes(mesh.positions) + bytes(mesh.normals) + bytes(mesh.texcoords) +
           bytes(mesh.colors) + bytes(mesh.corners) + bytes(mesh.faces);
  return sum;
}

std::size_t triangle_number_count(const Scene& scene) {
  std::size_t numbers = 0;
  for (const Instance& instance : scene.instances) {
    for (const auto& face : scene.meshes[instance.mesh].faces)
      numbers += glassbox::triangle_number_count(face);
  }
  return numbers;
}

}  // namespace glassbox::views
