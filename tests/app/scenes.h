// Makes small scenes with the library, for the program to render.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/app/working_directory.h"

#include <glassbox/mesh/gltf/write.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::test {

using Triple = std::array<float, 3>;

// Returns a mesh of triangles in which each corner has a position of its own. `normals` has as many
// elements as `positions`, or none (flat).
inline Mesh triangles(const std::vector<Triple>& positions,
                      const std::vector<Triple>& normals = {}) {
  Mesh mesh;
  for (const Triple& p : positions) mesh.positions.push_back({p[0], p[1], p[2]});
  for (const Triple& n : normals) mesh.normals.push_back({n[0], n[1], n[2]});
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    Corner corner;
    corner.position = i;
    if (!normals.empty()) corner.normal = i;
    mesh.corners.push_back(corner);
    if (i % 3 == 0) mesh.faces.push_back({i, 3});
  }
  return mesh;
}

// A scale, followed by a translation.
struct Placement {
  std::array<double, 3> scale{1, 1, 1};
  std::array<double, 3> offset{0, 0, 0};
};

// Writes the GLB file `name` with an instance of the mesh for each placement.
inline void write_scene(const WorkingDirectory& here, const std::string& name, const Mesh& mesh,
                        const std::vector<Placement>& places) {
  Scene scene;
  scene.materials.emplace_back();
  scene.materials[0].base_color = {0.8f, 0.6f, 0.4f, 1};
  scene.meshes.push_back(mesh);
  for (const Placement& place : places) {
    Node node;
    for (int axis = 0; axis < 3; ++axis) {
      node.parent_from_node.at(axis, axis) = place.scale[std::size_t(axis)];
      node.parent_from_node.at(axis, 3) = place.offset[std::size_t(axis)];
    }
    node.world_from_node = node.parent_from_node;
    scene.instances.push_back({0, std::uint32_t(scene.nodes.size())});
    scene.nodes.push_back(node);
  }
  if (const auto written = write_glb(scene, here.file(name)); !written) {
    throw std::runtime_error(written.error().message());
  }
}

// A box from `low` to `high` with outward faces.
inline Mesh box(const Triple& low, const Triple& high) {
  const auto corner = [&](int i) {
    return Triple{i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]};
  };
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<Triple> positions;
  for (const auto& side : kSides) {
    for (const int k : {0, 1, 2, 0, 2, 3}) positions.push_back(corner(side[k]));
  }
  return triangles(positions);
}

}  // namespace glassbox::test
