// Triangles given on the screen, as a scene that a whole run draws there.
#pragma once

#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/tile/tile_engine.h>

#include "study/extremes/kit/coverage.h"

namespace glassbox::study {

struct ScreenScene {
  Scene scene;
  View view;
};

// All triangles as one mesh of one double-sided material, seen by a parallel camera that carries them to where they were
// given: exactly where `side`, the picture's width and height, is a power of two and coordinates have few bits; elsewhere
// all that share a vertex still share it.
ScreenScene screen_scene(const std::vector<ScreenTriangle>& triangles, int side,
                         const Material& material);

// Shows its own colour, from both sides.
Material unlit_material();

// Which triangle each pixel shows where the first drawn stays, 1 + its number, 0 for none; and how often it is covered.
struct TrianglesDrawn {
  Image<int> first, times;
};
TrianglesDrawn triangles_drawn(const std::vector<ScreenTriangle>& triangles, int side);
// By two runs of the tile engine: opaque, then blended, where nothing hides anything.
TrianglesDrawn drawn_by_tile_engine(const std::vector<ScreenTriangle>& triangles, int side,
                                    const TileOptions& options);

// A mesh with the triangle's positions added, as a face.
void add_triangle(Mesh& mesh, const std::array<Point<Object>, 3>& corners);
Scene scene_of(Mesh mesh, const Material& material);

}  // namespace glassbox::study
