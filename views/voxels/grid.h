// Where voxels are: cubes in rows, columns and layers of a box, whose axes need not be the world's.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/base/error.h>

#include "views/rings/ring.h"

namespace glassbox::views {

struct VoxelAt {
  int x = 0, y = 0, z = 0;
  friend bool operator==(const VoxelAt&, const VoxelAt&) = default;
};

// Where a voxel stands among all of a box of so many, x first.
inline std::size_t voxel_index(const std::array<int, 3>& count, const VoxelAt& at) {
  return (std::size_t(at.z) * std::size_t(count[1]) + std::size_t(at.y)) * std::size_t(count[0]) +
         std::size_t(at.x);
}

// One number for each voxel of any grid, and for those beside it.
inline std::uint64_t key_of(const VoxelAt& at) {
  return std::uint64_t(at.z + 1) << 42 | std::uint64_t(at.y + 1) << 21 | std::uint64_t(at.x + 1);
}

struct VoxelGrid {
  Vector3d corner = Vector3d::Zero();    // of voxel (0, 0, 0), world
  Matrix3d axes = Matrix3d::Identity();  // columns: unit vectors along which x, y and z count
  double size = 1;                       // world units: a voxel's edge
  std::array<int, 3> count{1, 1, 1};     // voxels along x, y, z

  std::int64_t voxels() const { return std::int64_t(count[0]) * count[1] * count[2]; }
  std::size_t index(const VoxelAt& at) const { return voxel_index(count, at); }
  // The world's place of grid coordinates: voxel (x, y, z) is the cube from (x, y, z) to (x + 1, y + 1, z + 1).
  Vector3d world(double x, double y, double z) const {
    return corner + axes * (size * Vector3d(x, y, z));
  }
  Vector3d centre(const VoxelAt& at) const { return world(at.x + 0.5, at.y + 0.5, at.z + 0.5); }
  // Grid coordinates of a place in the world.
  Vector3d coordinates(const Vector3d& place) const {
    return axes.transpose() * (place - corner) / size;
  }
};

inline constexpr int kMostVoxelsAlong = 4096;
inline constexpr const char* kVoxelOption = "--voxel";

// Of voxels of this size that cover the box, along the axes given. Refused, in the name of kVoxelOption: sizes that are not positive, and
// more than kMostVoxelsAlong voxels along an axis.
Result<VoxelGrid> grid_of(const WorldBox& box, double size, const Matrix3d& axes);

// The edge at which a grid along the world's axes has this many voxels along the box's longest side.
double size_for(const WorldBox& box, int voxels_along);

// The edge at which it has about this many voxels in all.
double size_for_total(const WorldBox& box, double voxels);

}  // namespace glassbox::views
