// Voxel colouring for the checks and the drawing of lab 13, written word for word as its
// definitions say, without shortcuts.
#pragma once

#include <vector>

#include "labs/13-voxels/student.h"

namespace glassbox::labs::voxels {

lab_13::Order classify(const std::vector<lab_13::Place>& cameras, const lab_13::Box& box);

// The mean and the deviation are computed in long double, so that the remaining rounding errors are
// far below the bounds.
lab_13::Statistics statistics(const std::vector<lab_13::Colour>& colours);
inline constexpr double kUnit = 0x1p-53;
double mean_bound(const std::vector<lab_13::Colour>& colours);
double deviation_bound(const std::vector<lab_13::Colour>& colours, double deviation);

lab_13::Verdict judge(const std::vector<std::vector<lab_13::Pixel>>& pictures,
                      const lab_13::Threshold& threshold);

std::vector<lab_13::PixelAt> footprint(const lab_13::Projection& pixel_from_grid,
                                       const lab_13::Voxel& voxel, int width, int height);

std::vector<lab_13::Coloured> sweep(std::vector<lab_13::Picture> pictures, const lab_13::Grid& grid,
                                    const lab_13::Threshold& threshold);

}  // namespace glassbox::labs::voxels
