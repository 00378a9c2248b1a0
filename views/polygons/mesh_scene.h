// Surfaces as scenes, which `render` draws and a GLB file holds, and as PLY files.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/polygons/coloring.h"

namespace glassbox::views {

// Refused: voxels so small or so far away that the floats of a file do not keep apart what polygonise() does.
Result<void> check_floats(const VoxelGrid& grid);

// What the scene takes for a polygon: a colour, a face, three corners and half a place.
inline constexpr double kBytesOfScenePolygon =
    sizeof(Rgba) + sizeof(Face) + 3 * sizeof(Corner) + sizeof(Point<Object>) / 2.0;
// One mesh, unlit, its polygons in their order and with their colours at their corners. World units, in float, as check_floats asks.
Result<Scene> scene_of(const PolygonColoring& coloring);

// Binary, little-endian: corners that polygons share have the mean of their colours.
Result<std::string> polygons_ply(const PolygonColoring& coloring);

}  // namespace glassbox::views
