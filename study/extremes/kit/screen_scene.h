// Triangles given on the screen, as a scene that a whole run draws there.
#pragma once

#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

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

// The triangles of the scene's first mesh, each as a mesh and an instance of its own.
Scene in_draws(const Scene& scene);

// Shows its own colour, from both sides.
Material unlit_material();

// Which triangle each pixel shows where the first drawn stays, 1 + its number, 0 for none; and how often it is covered.
struct TrianglesDrawn {
  Image<int> first, times;
};

// A mesh with the triangle's positions added, as a face.
void add_triangle(Mesh& mesh, const std::array<Point<Object>, 3>& corners);
Scene scene_of(Mesh mesh, const Material& material);

}  // namespace glassbox::study
