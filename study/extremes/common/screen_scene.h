// Turns triangles in screen coordinates into a scene that a complete run draws at the same place.
#pragma once

#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

#include "study/extremes/common/coverage.h"

namespace glassbox::study {

struct ScreenScene {
  Scene scene;
  View view;
};

// Makes one mesh with a double-sided material from all triangles, and a parallel camera that
// projects them to the given places. The places are exact if `side`, the picture's width and
// height, is a power of two and the coordinates have few bits; otherwise shared vertices at least
// stay shared.
ScreenScene screen_scene(const std::vector<ScreenTriangle>& triangles, int side,
                         const Material& material);

// Turns each triangle of the scene's first mesh into a mesh and an instance of its own.
Scene one_draw_per_triangle(const Scene& scene);

// A double-sided material that shows its own colour.
Material unlit_material();

// `first` is the triangle that each pixel shows if later ones do not replace the first one drawn
// there; triangles are counted from 1, and 0 means none. `times` is how often the pixel is covered.
struct TriangleCoverage {
  Image<int> first, times;
};

// Adds a triangle to the mesh: its positions and a face.
void add_triangle(Mesh& mesh, const std::array<Point<Object>, 3>& corners);
Scene scene_of(Mesh mesh, const Material& material);

}  // namespace glassbox::study
