// Converts surfaces to scenes, which `render` draws and a GLB file stores, and to PLY files.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/polygons/coloring.h"

namespace glassbox::views {

// An error for voxels so small or so far away that corners which polygonise() keeps apart would be
// equal as floats in a file.
Result<void> check_floats(const VoxelGrid& grid);

// Bytes of the scene for each polygon: a colour, a face, three corners and half a position.
inline constexpr double kBytesOfScenePolygon =
    sizeof(Rgba) + sizeof(Face) + 3 * sizeof(Corner) + sizeof(Point<Object>) / 2.0;
// The scene has one unlit mesh with the polygons in the same order, each with its colour at its
// corners. Positions are in world units, in float, and checked by check_floats.
Result<Scene> scene_of(const PolygonColoring& coloring);

// Binary, little-endian. A corner that polygons share has the mean of their colours.
Result<std::string> polygons_ply(const PolygonColoring& coloring);

}  // namespace glassbox::views
