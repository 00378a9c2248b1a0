// Surfaces as scenes, which `render` draws and a GLB file holds, and as PLY files.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/polygons/coloring.h"

namespace glassbox::views {

// One mesh, unlit, its polygons in their order and with their colours at their corners. World units, in float.
Result<Scene> scene_of(const PolygonColoring& coloring);

// Binary, little-endian: corners that polygons share have the mean of their colours.
Result<std::string> polygons_ply(const PolygonColoring& coloring);

}  // namespace glassbox::views
