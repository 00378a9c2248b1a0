// Stores which voxels are full, with one bit for each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "views/polygons/scalar_field.h"
#include "views/voxels/coloring.h"

namespace glassbox::views {

class Occupancy {
public:
  explicit Occupancy(const VoxelGrid& grid);

  const VoxelGrid& grid() const { return grid_; }
  // Voxels outside of the grid are empty.
  bool has(const VoxelPosition& at) const {
    if (!is_within(at)) return false;
    const std::size_t i = index(at);
    return (bits_[i / 64] >> (i % 64) & 1) != 0;
  }
  void set(const VoxelPosition& at, bool full);
  void fill(const VoxelRun& run);
  // Fills those voxels of a layer that a sweep did not prove to be empty: the coloured ones, and
  // those hidden behind them.
  void fill(std::span<const VoxelRun> runs, std::span<const Verdict> verdicts);
  std::int64_t full() const;

  // 1 for full and 0 for empty voxels: corner (x, y, z) of the lattice is the centre of that voxel.
  ScalarField field() const;
  // At each voxel's centre the fraction of full voxels among the 27 around it, kept on the voxel's
  // own side of 1/2: the surface has the same polygons as with field(), at smoother positions.
  ScalarField smooth_field() const;

  static double bytes_for(const VoxelGrid& grid) { return double(grid.voxels()) / 8; }

private:
  bool is_within(const VoxelPosition& at) const {
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < grid_.count[0] && at.y < grid_.count[1] &&
           at.z < grid_.count[2];
  }
  std::size_t index(const VoxelPosition& at) const {
    return (std::size_t(at.z) * std::size_t(grid_.count[1]) + std::size_t(at.y)) *
               std::size_t(grid_.count[0]) +
           std::size_t(at.x);
  }

  VoxelGrid grid_;
  std::vector<std::uint64_t> bits_;
};

// The world position of a point of a lattice whose corners are the centres of voxels.
inline Vector3d world_of_lattice(const VoxelGrid& grid, const Vector3d& at) {
  return grid.world(at.x() + 0.5, at.y() + 0.5, at.z() + 0.5);
}

}  // namespace glassbox::views
