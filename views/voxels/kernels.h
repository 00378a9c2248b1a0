// The inner loop of the sweep: a row of voxels looked up in all pictures, compiled once for each instruction set. Floats in one
// written order and sums of whole numbers: every target gives the same bytes.
#pragma once

#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// Where the centres of a row of voxels are in a picture: voxel i at the pixel (x + i dx, y + i dy) / (w + i dw).
struct RowPicture {
  float x, y, w, dx, dy, dw;
  float width, height;  // px
  std::int32_t stride;
  std::int32_t beside;         // -1: what is beside the picture is background; else 0
  bool is_trial;               // after it, voxels whose colours differ too much are given up
  const std::int32_t* words;   // packed_picture.h
  const std::int32_t* spread;  // null where it is not asked for
};

// What the pictures say of each voxel of a row; the arrays have room for kMostLanes more than there are voxels.
struct RowSums {
  std::int32_t* count;  // pictures that see it, or kIsBackground, or kIsInconsistent
  std::int32_t *a, *b, *c, *squares;
  std::int32_t *spread, *least_spread;
};
inline constexpr std::int32_t kIsBackground = -1, kIsInconsistent = -2;
inline constexpr int kMostLanes = 16;

struct VoxelKernels {
  // Voxels first .. first + count - 1. Of a voxel that is background in one of the pictures, no more is asked, nor of one whose sum of
  // squared deviations (K times it, in codes) is beyond K `most_deviations`: it only grows. That is tried after some of the pictures.
  void (*sum_row)(const RowPicture* pictures, int picture_count, int first, int count,
                  float most_deviations, const RowSums& out);
};

const VoxelKernels& voxel_kernels(Target target);

// The early end of sum_row, for the single voxels of other ways: K squares - |sums|^2 > K most. `share` takes off what the products
// may have been rounded up by.
inline constexpr float kShareKept = 1 - 0x1p-20f;
inline constexpr int kPicturesBetweenTrials =
    4;  // of those that are asked: is_trial of every fourth

}  // namespace glassbox::views
