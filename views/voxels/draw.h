// Coloured voxels seen by a camera, and how far that is from its picture (S1-36).
#pragma once

#include <vector>

#include "views/voxels/coloring.h"

namespace glassbox::views {

struct VoxelPicture {
  Image<Rgba8> color;  // background where no voxel is
  Image<float>
      distance;  // along the gaze, of the centre of the nearest voxel; infinite where none is
};

// Each voxel covers the pixels whose centres are in its projection; of two, the nearer centre stays, the first of equals.
VoxelPicture draw_voxels(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                         const PinholeCamera& camera, int width, int height, Rgba8 background);

struct PictureErrors {
  double rms = 0;  // levels of 0 .. 255, over the channels of the object's pixels that are covered
  double rms_percent = 0;   // of 255
  double covered = 0;       // share of the object's pixels that a voxel covers
  double beside = 0;        // pixels covered beside the object, as a share of the object's
  std::int64_t pixels = 0;  // the object's: all, where the picture has no matte
};
PictureErrors compare(const VoxelPicture& drawn, const CalibratedPicture& picture);

}  // namespace glassbox::views
