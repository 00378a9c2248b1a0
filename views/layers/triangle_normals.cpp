#include "views/layers/triangle_normals.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include <glassbox/mesh/triangulate.h>

namespace glassbox::views {

SampleNormal stored_normal(double x, double y, double z) {
  const Eigen::Vector3d normal = Eigen::Vector3d(x, y, z).stableNormalized() * 127;
  if (!normal.allFinite()) return {};
  const auto stored = [](double number) { return std::int8_t(std::lround(number)); };
  return {stored(normal.x()), stored(normal.y()), stored(normal.z())};
}

std::vector<SampleNormal> triangle_normals(const Scene& scene) {
  std::vector<SampleNormal> normals(1);
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Transform<World, Object>& world_from_object = scene.nodes[instance.node].world_from_node;
    const Triangulation triangulation = triangulate(mesh);
    const std::size_t first = normals.size();
    normals.resize(first + triangulation.numbered);
    for (const Triangle& triangle : triangulation.triangles) {
      std::array<Eigen::Vector3d, 3> at;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point<Object>& p = mesh.positions[mesh.corners[triangle.corners[k]].position];
        const Point<World, double> w = world_from_object * Point<Object, double>(p.x, p.y, p.z);
        at[k] = {w.x, w.y, w.z};
      }
      const Eigen::Vector3d normal = (at[1] - at[0]).cross(at[2] - at[0]);
      normals[first + triangle.number] = stored_normal(normal.x(), normal.y(), normal.z());
    }
  }
  return normals;
}

}  // namespace glassbox::views
