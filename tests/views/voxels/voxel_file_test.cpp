// Voxels in files, and the true volume with which they are compared.
#include <tests/support/catch.h>

#include <glassbox/mesh/ply/load.h>

#include "tests/views/voxels/flat_scene.h"
#include "tests/views/voxels/rig.h"
#include "views/voxels/voxel_file.h"

namespace glassbox::views {

using namespace test;

TEST_CASE("voxels are written as cubes without inner faces, which are read again") {
  VoxelGrid grid;
  grid.size = 0.5;
  const std::vector<ColoredVoxel> voxels{colored_voxel(0, 0, 0, kRed),
                                         colored_voxel(1, 0, 0, kBlue)};
  const auto scene = load_ply_memory(voxels_ply(grid, voxels, VoxelShape::kCubes));
  REQUIRE(scene);
  REQUIRE(scene->meshes.size() == 1);
  CHECK(scene->meshes[0].faces.size() == 10);
  const WorldBox box = box_of(*scene);
  CHECK(box.low == Vector3d(0, 0, 0));
  CHECK(box.high == Vector3d(1, 0.5, 0.5));
  // Faces are counter-clockwise as seen from outside: by the divergence theorem the volume is that
  // of both voxels, 2 / 8.
  const Mesh& mesh = scene->meshes[0];
  double volume = 0;
  for (const Face& face : mesh.faces) {
    const auto place = [&](std::uint32_t corner) {
      const Point<Object>& p = mesh.positions[mesh.corners[face.first + corner].position];
      return Vector3d(double(p.x), double(p.y), double(p.z));
    };
    for (std::uint32_t i = 2; i < face.count; ++i)
      volume += place(0).dot(place(i - 1).cross(place(i))) / 6;
  }
  CHECK(std::abs(volume - 0.25) < 1e-12);
  const std::string points = voxels_ply(grid, voxels, VoxelShape::kPoints);
  CHECK(points.find("element vertex 2") != std::string::npos);
  CHECK(points.find("element face") == std::string::npos);
}

TEST_CASE("what is inside of a scene is found by winding") {
  const Scene cube = *make_builtin("cube");
  const VoxelGrid grid = grid_of({{-2, -2, -2}, {2, 2, 2}}, 0.25, Matrix3d::Identity()).value();
  const TrueVolume inside(cube, grid);
  CHECK(inside.voxels() == 8 * 8 * 8);
  CHECK(inside.has({4, 4, 4}));
  CHECK_FALSE(inside.has({3, 8, 8}));
  CHECK(inside.has({11, 11, 11}));
}

}  // namespace glassbox::views
