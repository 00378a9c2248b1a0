// Draws coloured voxels as seen by a camera, and compares the result with the camera's picture
// (S1-36).
#pragma once

#include <vector>

#include "views/voxels/coloring.h"

namespace glassbox::views {

struct VoxelPicture {
  Image<Rgba8> color;  // background where there is no voxel
  // How far the nearest voxel's centre is along the direction of view; infinite without a voxel.
  Image<float> distance;
};

// Each voxel covers the pixels whose centres are in its projection. Where two voxels overlap, the
// one with the nearer centre is drawn; of equally near ones the first.
VoxelPicture draw_voxels(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                         const PinholeCamera& camera, int width, int height, Rgba8 background);

struct PictureErrors {
  // In levels of 0 .. 255, over the channels of those pixels of the object that a voxel covers.
  double rms = 0;
  double rms_percent = 0;   // `rms` as a percentage of 255
  double covered = 0;       // fraction of the object's pixels that a voxel covers
  double beside = 0;        // pixels covered outside of the object, divided by the object's pixels
  std::int64_t pixels = 0;  // the object's; all pixels if the picture has no matte
};
PictureErrors voxel_picture_errors(const VoxelPicture& drawn, const CalibratedPicture& picture);

}  // namespace glassbox::views
