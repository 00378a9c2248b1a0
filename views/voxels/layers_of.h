// The voxels of each layer, as runs: planes along an axis, shells around cameras, and the few that a coarser level leaves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "views/voxels/sweep.h"

namespace glassbox::views {

// Layers 0 .. n - 1 of planes: along direction[0], from its low end if direction[1] is 1.
class PlaneLayers {
public:
  PlaneLayers(const VoxelGrid& grid, std::array<int, 2> direction);
  int count() const { return grid_.count[std::size_t(axis_)]; }
  // The coordinate of layer k.
  int place(int k) const { return forward_ ? k : count() - 1 - k; }
  // The layer that a voxel is of.
  int layer_of(const VoxelAt& at) const {
    const int place = axis_ == 0 ? at.x : axis_ == 1 ? at.y : at.z;
    return forward_ ? place : count() - 1 - place;
  }
  // All of its voxels whose centres are in the box.
  std::vector<VoxelRun> runs(int k, const WorldBox& box) const;

private:
  const VoxelGrid& grid_;
  int axis_, row_, column_;
  bool forward_;
};

// Shells around the voxels that have cameras in them: layer k has the voxels that are k + 1 away from the box of those, counted along
// the axis along which it is most. That distance is a convex function which is 0 in the box, so it grows along every ray from a
// camera; what is in the box itself is taken for empty.
class ShellLayers {
public:
  ShellLayers(const VoxelGrid& grid, const std::vector<Vector3d>& cameras);
  int count() const { return layers_; }
  std::vector<VoxelRun> runs(int k) const;

private:
  const VoxelGrid& grid_;
  std::array<int, 3> low_, high_;
  int layers_ = 0;
};

// One byte for each cell of a coarser level.
class Cells {
public:
  explicit Cells(const VoxelGrid& grid);
  void set(const VoxelAt& at) { bytes_[index(at)] = 1; }
  // And those around each, corners too.
  void grow();
  // Of a layer of the next finer level: the runs whose cells are set.
  std::vector<VoxelRun> finer(const std::vector<VoxelRun>& runs) const;

private:
  std::size_t index(const VoxelAt& at) const { return voxel_index(count_, at); }
  std::array<int, 3> count_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace glassbox::views
