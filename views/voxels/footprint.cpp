#include "views/voxels/footprint.h"

namespace glassbox::views {

GridPicture grid_picture(const VoxelGrid& grid, const PackedPicture& picture) {
  Eigen::Matrix4d world_from_grid = Eigen::Matrix4d::Identity();
  world_from_grid.topLeftCorner<3, 3>() = grid.size * grid.axes;
  world_from_grid.topRightCorner<3, 1>() = grid.corner;
  GridPicture lens;
  lens.pixel_from_grid = picture.pixel_from_world * world_from_grid;
  for (int i = 0; i < 8; ++i) {
    const Vector3d way((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                       (i & 4) != 0 ? 0.5 : -0.5);
    const Vector3d h = lens.pixel_from_grid.leftCols<3>() * way;
    lens.corner_x[std::size_t(i)] = float(h.x());
    lens.corner_y[std::size_t(i)] = float(h.y());
    lens.corner_w[std::size_t(i)] = float(h.z());
  }
  lens.width = float(picture.width);
  lens.height = float(picture.height);
  lens.stride = picture.width;
  return lens;
}

RowPicture row_of(const GridPicture& lens, const PackedPicture& picture, const VoxelAt& at,
                  int axis) {
  Eigen::Vector4d start(at.x + 0.5, at.y + 0.5, at.z + 0.5, 1);
  start[axis] = 0.5;
  const Vector3d h = lens.pixel_from_grid * start;
  const auto& step = lens.pixel_from_grid.col(axis);
  const auto* words = reinterpret_cast<const std::int32_t*>(picture.words.data());
  const auto* spread = reinterpret_cast<const std::int32_t*>(picture.spread.data());
  return {float(h.x()),    float(h.y()),
          float(h.z()),    float(step.x()),
          float(step.y()), float(step.z()),
          lens.width,      lens.height,
          lens.stride,     picture.has_whole ? -1 : 0,
          words,           picture.spread.empty() ? nullptr : spread};
}

}  // namespace glassbox::views
