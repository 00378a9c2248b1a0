#include "views/voxels/grid.h"

#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/elementary.h>

namespace glassbox::views {

Result<VoxelGrid> grid_of(const WorldBox& box, double size, const Matrix3d& axes) {
  if (!(size > 0) || !std::isfinite(size))
    return fail(kVoxelOption, "a voxel's edge must be positive", "give a length in world units");
  if (!((box.high - box.low).minCoeff() > 0) || !box.low.allFinite() || !box.high.allFinite()) {
    return fail("--box", "the box is empty",
                "give the corner of least coordinates, then the corner of greatest coordinates");
  }
  Vector3d low = Vector3d::Constant(INFINITY), high = Vector3d::Constant(-INFINITY);
  for (const Vector3d& p : corners_of(box)) {
    const Vector3d along = axes.transpose() * p;
    low = low.cwiseMin(along);
    high = high.cwiseMax(along);
  }
  VoxelGrid grid;
  grid.axes = axes;
  grid.size = size;
  grid.corner = axes * low;
  for (int axis = 0; axis < 3; ++axis) {
    // A part of the box that extends beyond the last voxel only by rounding needs no voxel of its
    // own.
    constexpr double kRounding = 1e-9;
    const double along = std::ceil((high[axis] - low[axis]) / size - kRounding);
    if (!(along <= kMaxVoxelsAlong)) {
      return fail(kVoxelOption,
                  fmt::format("the box has {:.4g} voxels along an axis, but {} are the most", along,
                              kMaxVoxelsAlong),
                  "use larger voxels or a smaller box");
    }
    grid.count[std::size_t(axis)] = std::max(1, int(along));
  }
  return grid;
}

double size_for(const WorldBox& box, int voxels_along) {
  return (box.high - box.low).maxCoeff() / voxels_along;
}

double size_for_total(const WorldBox& box, double voxels) {
  return cube_root((box.high - box.low).prod() / voxels);
}

}  // namespace glassbox::views
