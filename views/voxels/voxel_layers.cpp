#include "views/voxels/voxel_layers.h"

#include <algorithm>
#include <cmath>

namespace glassbox::views {

namespace {

VoxelPosition voxel_at(const std::array<int, 3>& at) {
  return {at[0], at[1], at[2]};
}

// The part of a run whose centres are inside a box.
VoxelRun clipped(VoxelRun run, const VoxelGrid& grid, const WorldBox& box) {
  const Vector3d start = grid.centre(run.first), step = grid.size * grid.axes.col(run.axis);
  // Centres that are outside only by rounding are taken to be inside.
  const double room = grid.size * 1e-6;
  double from = 0, to = run.count - 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - room - start[axis],
                 high = box.high[axis] + room - start[axis];
    if (std::abs(step[axis]) < grid.size * 1e-9) {
      if (low > 0 || high < 0) to = -1;
      continue;
    }
    const double a = low / step[axis], b = high / step[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  const int first = int(std::ceil(from)), last = int(std::floor(to));
  if (last < first) return {run.first, run.axis, 0};
  return {run.at(first), run.axis, last - first + 1};
}

}  // namespace

PlaneLayers::PlaneLayers(const VoxelGrid& grid, std::array<int, 2> direction)
    : grid_(grid),
      axis_(direction[0]),
      row_((direction[0] + 1) % 3),
      column_((direction[0] + 2) % 3),
      forward_(direction[1] > 0) {}

std::vector<VoxelRun> PlaneLayers::runs(int k, const WorldBox& box) const {
  const bool is_aligned = grid_.axes.isIdentity();
  std::vector<VoxelRun> runs;
  for (int column = 0; column < grid_.count[std::size_t(column_)]; ++column) {
    std::array<int, 3> first{0, 0, 0};
    first[std::size_t(axis_)] = coordinate(k);
    first[std::size_t(column_)] = column;
    VoxelRun run{voxel_at(first), row_, grid_.count[std::size_t(row_)]};
    // In a grid along the world's axes no run is clipped: the last voxels may extend beyond the
    // box, by less than one voxel.
    if (!is_aligned) run = clipped(run, grid_, box);
    if (run.count > 0) runs.push_back(run);
  }
  return runs;
}

ShellLayers::ShellLayers(const VoxelGrid& grid, const std::vector<Vector3d>& cameras)
    : grid_(grid), low_{INT32_MAX, INT32_MAX, INT32_MAX}, high_{-1, -1, -1} {
  for (const Vector3d& camera : cameras) {
    const Vector3d at = grid.coordinates(camera);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int voxel = int(std::clamp(std::floor(at[int(axis)]), 0.0, grid.count[axis] - 1.0));
      low_[axis] = std::min(low_[axis], voxel);
      high_[axis] = std::max(high_[axis], voxel);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    layers_ = std::max({layers_, low_[axis], grid.count[axis] - 1 - high_[axis]});
}

std::vector<VoxelRun> ShellLayers::runs(int k) const {
  const int away = k + 1;
  std::vector<VoxelRun> runs;
  const auto from = [&](std::size_t axis, int room) { return std::max(low_[axis] - room, 0); };
  const auto to = [&](std::size_t axis, int room) {
    return std::min(high_[axis] + room, grid_.count[axis] - 1);
  };
  const auto has = [&](std::size_t axis, int at) { return at >= 0 && at < grid_.count[axis]; };
  // The shell is the surface of a box: first both faces across z, then the rest of the faces across
  // y, then the rest of the faces across x.
  const auto add = [&](VoxelPosition first, int axis, int last) {
    const VoxelRun run{first, axis, last - VoxelRun{first, axis, 0}.begin() + 1};
    if (run.count > 0) runs.push_back(run);
  };
  for (const int z : {low_[2] - away, high_[2] + away}) {
    if (!has(2, z)) continue;
    for (int y = from(1, away); y <= to(1, away); ++y) add({from(0, away), y, z}, 0, to(0, away));
  }
  for (const int y : {low_[1] - away, high_[1] + away}) {
    if (!has(1, y)) continue;
    for (int z = from(2, away - 1); z <= to(2, away - 1); ++z)
      add({from(0, away), y, z}, 0, to(0, away));
  }
  for (const int x : {low_[0] - away, high_[0] + away}) {
    if (!has(0, x)) continue;
    for (int z = from(2, away - 1); z <= to(2, away - 1); ++z)
      add({x, from(1, away - 1), z}, 1, to(1, away - 1));
  }
  return runs;
}

CellMask::CellMask(const VoxelGrid& grid)
    : count_(grid.count), bytes_(std::size_t(grid.voxels()), 0) {}

void CellMask::grow() {
  std::size_t step = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t along = std::size_t(count_[axis]);
    std::vector<std::uint8_t> grown = bytes_;
    for (std::size_t begin = 0; begin < bytes_.size(); begin += step * along) {
      for (std::size_t i = begin; i + step < begin + step * along; ++i) {
        grown[i] |= bytes_[i + step];
        grown[i + step] |= bytes_[i];
      }
    }
    bytes_ = std::move(grown);
    step *= along;
  }
}

std::vector<VoxelRun> CellMask::refined(const std::vector<VoxelRun>& runs) const {
  std::vector<VoxelRun> some;
  for (const VoxelRun& run : runs) {
    const auto is_set = [&](int i) {
      const VoxelPosition at = run.at(i);
      return bytes_[index({std::min(at.x / 2, count_[0] - 1), std::min(at.y / 2, count_[1] - 1),
                           std::min(at.z / 2, count_[2] - 1)})] != 0;
    };
    for (int i = 0; i < run.count;) {
      if (!is_set(i)) {
        ++i;
        continue;
      }
      const int begin = i;
      while (i < run.count && is_set(i)) ++i;
      some.push_back({run.at(begin), run.axis, i - begin});
    }
  }
  return some;
}

}  // namespace glassbox::views
