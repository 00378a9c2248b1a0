// The inner loop of the sweep: looks up a row of voxels in all pictures. Compiled once for each
// instruction set. It uses floats in the order of operations that the code states, and sums of
// integers, so that the result has the same bytes for every instruction set.
#pragma once

#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The positions of a row of voxels' centres in a picture: voxel i is at the pixel (x + i dx, y + i
// dy) / (w + i dw).
struct RowPicture {
  float x, y, w, dx, dy, dw;
  float width, height;  // px
  std::int32_t stride;
  std::int32_t beside;  // -1: everything outside of the picture is background; else 0
  bool is_trial;        // after this picture, voxels whose colours differ too much are given up
  const std::int32_t* words;   // see packed_picture.h
  const std::int32_t* spread;  // null if it is not needed
};

// The sums over the pictures for each voxel of a row; the arrays have room for kMaxLanes more
// numbers than there are voxels.
struct RowSums {
  // Number of pictures that see the voxel, or kIsBackground, or kIsInconsistent.
  std::int32_t* count;
  std::int32_t *a, *b, *c, *squares;
  std::int32_t *spread, *least_spread;
};
inline constexpr std::int32_t kIsBackground = -1, kIsInconsistent = -2;
inline constexpr int kMaxLanes = 16;

struct VoxelKernels {
  // Sums over voxels first .. first + count - 1. A voxel is given up when it is background in one
  // of the pictures, or when its sum of squared deviations, in codes, is above `most_deviations`,
  // because that sum can only grow. (In this comparison both sides are multiplied by the number of
  // pixels.) The comparison is made only after some of the pictures (is_trial).
  void (*sum_row)(const RowPicture* pictures, int picture_count, int first, int count,
                  float most_deviations, const RowSums& out);
};

const VoxelKernels& voxel_kernels(Target target);

// sum_row gives a voxel up early if K * squares - |sums|^2 > K * most_deviations, where K is the
// number of pixels. The first product is multiplied by this factor, which subtracts what rounding
// may have added to the products.
inline constexpr float kShareKept = 1 - 0x1p-20f;
// The number of pictures that sum_row looks at between two tests of the colours: is_trial is set in
// every fourth.
inline constexpr int kPicturesBetweenTrials = 4;

}  // namespace glassbox::views
