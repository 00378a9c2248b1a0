// Writes coloured voxels as PLY files.
#pragma once

#include <string>

#include "views/voxels/coloring.h"

namespace glassbox::views {

enum class VoxelShape { kCubes, kPoints };

// Binary, little-endian. Cubes have the faces that are not covered by another coloured voxel, with
// their voxel's colour at the corners; `glassbox render` draws them. Points have the voxels'
// centres, for programs that draw points.
std::string voxels_ply(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                       VoxelShape shape);

}  // namespace glassbox::views
