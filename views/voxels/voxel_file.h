// Coloured voxels as PLY files.
#pragma once

#include <string>

#include "views/voxels/coloring.h"

namespace glassbox::views {

enum class VoxelShape { kCubes, kPoints };

// Binary, little-endian. Cubes have the faces that no other coloured voxel covers, with the colours of their voxels at the corners, and
// `glassbox render` draws them; points have the centres, for programs that draw points.
std::string voxels_ply(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                       VoxelShape shape);

}  // namespace glassbox::views
