// The voxels of each layer, as runs. Layers are planes along an axis, shells around cameras, or the
// remaining cells of a coarser level.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "views/voxels/sweep.h"

namespace glassbox::views {

// Layers 0 .. n - 1 are planes along the axis direction[0], from its low end if direction[1] is 1,
// else from its high end.
class PlaneLayers {
public:
  PlaneLayers(const VoxelGrid& grid, std::array<int, 2> direction);
  int count() const { return grid_.count[std::size_t(axis_)]; }
  // The coordinate of layer k along the axis.
  int coordinate(int k) const { return forward_ ? k : count() - 1 - k; }
  // The number of a voxel's layer.
  int layer_of(const VoxelPosition& at) const {
    const int place = axis_ == 0 ? at.x : axis_ == 1 ? at.y : at.z;
    return forward_ ? place : count() - 1 - place;
  }
  // All voxels of layer k. In a grid that is not along the world's axes, only those whose centres
  // are in the box.
  std::vector<VoxelRun> runs(int k, const WorldBox& box) const;

private:
  const VoxelGrid& grid_;
  int axis_, row_, column_;
  bool forward_;
};

// Shells around the cameras. The bounding box of the voxels that contain a camera is taken to be
// empty. Layer k has the voxels at the distance k + 1 from that box, measured along the axis along
// which the distance is largest. This distance is a convex function that is 0 in the box, so it
// grows along every ray from a camera.
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

// The cells of a coarser level, one byte each: 1 if the cell is set, so that its voxels are
// examined at the next level.
class CellMask {
public:
  explicit CellMask(const VoxelGrid& grid);
  void set(const VoxelPosition& at) { bytes_[index(at)] = 1; }
  // Sets all neighbours of set cells, too, including those that touch only at a corner.
  void grow();
  // For a layer of the next finer level, the parts of its runs that are in set cells.
  std::vector<VoxelRun> refined(const std::vector<VoxelRun>& runs) const;

private:
  std::size_t index(const VoxelPosition& at) const { return voxel_index(count_, at); }
  std::array<int, 3> count_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace glassbox::views
