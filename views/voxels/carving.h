// Space carving: what is left of a full box when all that is proved empty has been taken away (Kutulakos and Seitz 2000; S1-38).
#pragma once

#include <vector>

#include "views/voxels/coloring.h"

namespace glassbox::views {

// Sweeps along x, -x, y, -y, z, -z, each with the cameras that are before its plane, until a pass of six carves nothing, or the last pass
// that the request allows, which `result` then says is not finished. Voxels that
// fewer than two pictures see stay, as nothing proves that they are empty. `result` has the grid; its voxels are those at the surface
// of what remains that some picture sees, with what all of them say, and its counts are of these.
void carve(std::vector<PackedPicture>& pictures, const ColoringRequest& request, Coloring& result);

// What carving takes beside its pictures, if so many voxels are left at the surface.
double carving_bytes(const VoxelGrid& grid, double surface);

}  // namespace glassbox::views
