// Space carving: starts with a full box and removes every voxel that is proved to be empty
// (Kutulakos and Seitz 2000; S1-38).
#pragma once

#include <vector>

#include "views/voxels/coloring.h"

namespace glassbox::views {

// Sweeps along x, -x, y, -y, z, -z, each with the cameras that its plane has already passed, until
// a pass of six sweeps carves nothing, or until the last pass that the request allows; in that case
// `result` is marked as not finished. Voxels that fewer than two pictures see stay, because nothing
// proves that they are empty. `result` has the grid when carve() is called. It receives the voxels
// at the surface of what remains that some picture sees, with the colours from all pictures that
// see them, and the counts of these voxels.
void carve(std::vector<PackedPicture>& pictures, const ColoringRequest& request, Coloring& result);

// Bytes that carving needs besides its pictures, if this many voxels are left at the surface.
double carving_bytes(const VoxelGrid& grid, double surface);

}  // namespace glassbox::views
