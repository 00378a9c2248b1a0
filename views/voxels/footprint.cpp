#include "views/voxels/footprint.h"

#include <limits>

namespace glassbox::views {

GridPicture grid_picture(const VoxelGrid& grid, const ProjectionMatrix& pixel_from_world, int width,
                         int height) {
  Eigen::Matrix4d world_from_grid = Eigen::Matrix4d::Identity();
  world_from_grid.topLeftCorner<3, 3>() = grid.size * grid.axes;
  world_from_grid.topRightCorner<3, 1>() = grid.corner;
  GridPicture lens;
  lens.pixel_from_grid = pixel_from_world * world_from_grid;
  for (int i = 0; i < 8; ++i) {
    const Vector3d way((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                       (i & 4) != 0 ? 0.5 : -0.5);
    const Vector3d h = lens.pixel_from_grid.leftCols<3>() * way;
    lens.corner_x[std::size_t(i)] = float(h.x());
    lens.corner_y[std::size_t(i)] = float(h.y());
    lens.corner_w[std::size_t(i)] = float(h.z());
  }
  lens.width = float(width);
  lens.height = float(height);
  lens.stride = width;
  return lens;
}

GridPicture grid_picture(const VoxelGrid& grid, const PackedPicture& picture) {
  return grid_picture(grid, picture.pixel_from_world, picture.width, picture.height);
}

bool is_finite(const GridPicture& lens) {
  // The position of the farthest voxel must be finite, too. It is a sum of three products and the
  // constant column, which are added in double before they are rounded.
  const double most = lens.pixel_from_grid.cwiseAbs().maxCoeff() * (3.0 * kMaxVoxelsAlong + 1);
  return most <= double(std::numeric_limits<float>::max());
}

Projected centre_of(const GridPicture& lens, const VoxelPosition& at) {
  return projected(row_of(lens, at, 0), at.x);
}

RowPicture row_of(const GridPicture& lens, const VoxelPosition& at, int axis) {
  Eigen::Vector4d start(at.x + 0.5, at.y + 0.5, at.z + 0.5, 1);
  start[axis] = 0.5;
  const Vector3d h = lens.pixel_from_grid * start;
  const auto& step = lens.pixel_from_grid.col(axis);
  RowPicture row{};
  row.x = float(h.x());
  row.y = float(h.y());
  row.w = float(h.z());
  row.dx = float(step.x());
  row.dy = float(step.y());
  row.dw = float(step.z());
  row.width = lens.width;
  row.height = lens.height;
  row.stride = lens.stride;
  return row;
}

RowPicture row_of(const GridPicture& lens, const PackedPicture& picture, const VoxelPosition& at,
                  int axis) {
  RowPicture row = row_of(lens, at, axis);
  row.beside = picture.shows_whole_object ? -1 : 0;
  row.words = reinterpret_cast<const std::int32_t*>(picture.words.data());
  if (!picture.spread.empty())
    row.spread = reinterpret_cast<const std::int32_t*>(picture.spread.data());
  return row;
}

}  // namespace glassbox::views
