#include "views/polygons/mesh_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/images/srgb.h>
#include <glassbox/mesh/builtin/placement.h>

namespace glassbox::views {

namespace {

Rgba linear_of(const Rgba8& color) {
  return {decode_srgb(color.r), decode_srgb(color.g), decode_srgb(color.b), 1};
}

void add_number(std::string& text, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) text += char(value >> (8 * k) & 0xffu);
}

}  // namespace

// Corners of the surface are at least kMinStep of a voxel away from the lattice's corners, so two
// corners that are near the same lattice corner are at least that far apart along an axis. Floats
// keep them apart, in whatever direction they are rounded, if the distance between neighbouring
// floats is less than a fourth of that.
Result<void> check_floats(const VoxelGrid& grid) {
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d p = grid.world((corner & 1) * grid.count[0], (corner >> 1 & 1) * grid.count[1],
                                  (corner >> 2) * grid.count[2]);
    farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  }
  if (farthest * 0x1p-23 < grid.size * kMinStep / 4) return {};
  return fail("--box",
              fmt::format("voxels of size {:.3g} are {:.3g} from the origin, so far that the "
                          "floats in the file cannot distinguish their corners",
                          grid.size, farthest),
              "use larger voxels, or a world whose origin is near the object");
}

Result<Scene> scene_of(const PolygonColoring& coloring) {
  if (const auto legal = check_floats(coloring.grid); !legal) return tl::unexpected(legal.error());
  Scene scene;
  scene.name = "polygons";
  Mesh mesh;
  mesh.name = "polygons";
  mesh.positions.reserve(coloring.mesh.positions.size());
  mesh.faces.reserve(coloring.mesh.polygons.size());
  mesh.corners.reserve(3 * coloring.mesh.polygons.size());
  mesh.colors.reserve(coloring.mesh.polygons.size());
  for (const Vector3d& p : coloring.mesh.positions) {
    const Vector3d world = world_of_lattice(coloring.grid, p);
    mesh.positions.push_back({float(world.x()), float(world.y()), float(world.z())});
  }
  for (std::size_t i = 0; i < coloring.mesh.polygons.size(); ++i) {
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
    for (const std::uint32_t position : coloring.mesh.polygons[i])
      mesh.corners.push_back({position, kNone, kNone, std::uint32_t(i)});
    mesh.colors.push_back(linear_of(coloring.colors[i].color));
  }
  scene.materials[add_material(scene, "polygons", {1, 1, 1, 1})].unlit = true;
  add_object(scene, std::move(mesh));
  return scene;
}

Result<std::string> polygons_ply(const PolygonColoring& coloring) {
  if (const auto legal = check_floats(coloring.grid); !legal) return tl::unexpected(legal.error());
  const PolygonMesh& mesh = coloring.mesh;
  std::vector<std::array<std::int64_t, 4>> sums(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const Rgba8& color = coloring.colors[i].color;
    for (const std::uint32_t corner : mesh.polygons[i]) {
      auto& sum = sums[corner];
      sum = {sum[0] + color.r, sum[1] + color.g, sum[2] + color.b, sum[3] + 1};
    }
  }
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment made by glassbox views polygons\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.polygons.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector3d world = world_of_lattice(coloring.grid, mesh.positions[i]);
    for (int axis = 0; axis < 3; ++axis)
      add_number(text, std::bit_cast<std::uint32_t>(float(world[axis])));
    for (std::size_t c = 0; c < 3; ++c)
      text += char(sums[i][c] / std::max<std::int64_t>(1, sums[i][3]));
  }
  for (const PolygonCorners& polygon : mesh.polygons) {
    text += char(3);
    for (const std::uint32_t corner : polygon) add_number(text, corner);
  }
  return text;
}

}  // namespace glassbox::views
