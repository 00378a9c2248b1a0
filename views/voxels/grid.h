// Voxel grids: cubes in rows, columns and layers of a box, whose axes need not be the world's.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/base/error.h>

#include "views/rings/ring.h"

namespace glassbox::views {

struct VoxelPosition {
  int x = 0, y = 0, z = 0;
  friend bool operator==(const VoxelPosition&, const VoxelPosition&) = default;
};

// The index of a voxel in a box with `count` voxels along each axis; x changes fastest.
inline std::size_t voxel_index(const std::array<int, 3>& count, const VoxelPosition& at) {
  return (std::size_t(at.z) * std::size_t(count[1]) + std::size_t(at.y)) * std::size_t(count[0]) +
         std::size_t(at.x);
}

// A unique number for each voxel of any grid, and for the voxels next to it.
inline std::uint64_t key_of(const VoxelPosition& at) {
  return std::uint64_t(at.z + 1) << 42 | std::uint64_t(at.y + 1) << 21 | std::uint64_t(at.x + 1);
}

struct VoxelGrid {
  Vector3d corner = Vector3d::Zero();    // low corner of voxel (0, 0, 0), in the world
  Matrix3d axes = Matrix3d::Identity();  // columns: unit vectors of the grid's x, y and z axes
  double size = 1;                       // edge of a voxel, in world units
  std::array<int, 3> count{1, 1, 1};     // voxels along x, y, z

  std::int64_t voxels() const { return std::int64_t(count[0]) * count[1] * count[2]; }
  std::size_t index(const VoxelPosition& at) const { return voxel_index(count, at); }
  // The world position of grid coordinates: voxel (x, y, z) is the cube from (x, y, z) to (x + 1, y
  // + 1, z + 1).
  Vector3d world(double x, double y, double z) const {
    return corner + axes * (size * Vector3d(x, y, z));
  }
  Vector3d centre(const VoxelPosition& at) const {
    return world(at.x + 0.5, at.y + 0.5, at.z + 0.5);
  }
  // The grid coordinates of a world position.
  Vector3d coordinates(const Vector3d& place) const {
    return axes.transpose() * (place - corner) / size;
  }
};

inline constexpr int kMaxVoxelsAlong = 4096;
inline constexpr const char* kVoxelOption = "--voxel";

// A grid of voxels of this size, along these axes, that covers the box. An error with kVoxelOption
// in its message for sizes that are not positive, and for more than kMaxVoxelsAlong voxels along
// an axis.
Result<VoxelGrid> grid_of(const WorldBox& box, double size, const Matrix3d& axes);

// The voxel size with which a grid along the world's axes has this many voxels along the box's
// longest side.
double size_for(const WorldBox& box, int voxels_along);

// The voxel size with which a grid has about this many voxels in total.
double size_for_total(const WorldBox& box, double voxels);

}  // namespace glassbox::views
