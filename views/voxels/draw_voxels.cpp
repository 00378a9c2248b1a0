#include "views/voxels/draw_voxels.h"

#include <cmath>

namespace glassbox::views {

VoxelPicture draw_voxels(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                         const PinholeCamera& camera, int width, int height, Rgba8 background) {
  const GridPicture lens = grid_picture(grid, projection_of(camera), width, height);
  VoxelPicture drawn{{width, height, background}, {width, height, INFINITY}};
  for (const ColoredVoxel& voxel : voxels) {
    const Projected centre = centre_of(lens, voxel.at);
    if (!(centre.w > 0)) continue;
    for_each_pixel(lens, centre, Footprint::kHull, [&](int x, int y) {
      float& nearest = drawn.distance.at(x, y);
      if (!(centre.w < nearest)) return;
      nearest = centre.w;
      drawn.color.at(x, y) = voxel.color;
    });
  }
  return drawn;
}

PictureErrors voxel_picture_errors(const VoxelPicture& drawn, const CalibratedPicture& picture) {
  PictureErrors errors;
  double squares = 0;
  std::int64_t covered = 0, beside = 0;
  for (std::size_t i = 0; i < picture.color.pixels.size(); ++i) {
    const bool is_object = picture.matte.pixels.empty() || picture.matte.pixels[i] != 0;
    const bool is_drawn = std::isfinite(drawn.distance.pixels[i]);
    errors.pixels += is_object;
    beside += is_drawn && !is_object;
    if (!is_drawn || !is_object) continue;
    ++covered;
    const Rgba8 &found = drawn.color.pixels[i], &right = picture.color.pixels[i];
    for (const int d : {found.r - right.r, found.g - right.g, found.b - right.b})
      squares += double(d * d);
  }
  if (covered > 0) errors.rms = std::sqrt(squares / (3 * double(covered)));
  errors.rms_percent = errors.rms / 2.55;
  if (errors.pixels > 0) {
    errors.covered = double(covered) / double(errors.pixels);
    errors.beside = double(beside) / double(errors.pixels);
  }
  return errors;
}

}  // namespace glassbox::views
