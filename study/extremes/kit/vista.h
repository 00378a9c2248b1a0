// Scenes that are looked at, with all that is needed to say what is seen: the lens, and every triangle where it lies in eye space.
#pragma once

#include <array>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

struct SeenTriangle {
  std::array<std::array<long double, 3>, 3> corners{};  // eye space
  std::array<std::array<double, 2>, 3> texcoords{};
};

// A scene, how it is looked at, and the same as triangles in eye space, in the order in which the scene has them.
struct Vista {
  Scene scene;
  Lens lens;
  View view;
  RenderSettings settings;
  std::vector<SeenTriangle> triangles;
  // Surfaces whose distances differ by less, relatively, may hide each other.
  double separation = 1e-3;
  // What pixels must show besides the nearest triangle: its texel there, or its level of detail.
  enum class Texels { kNone, kEach, kLevels } texels = Texels::kNone;
};

// Floats as they are given to the pipeline, with the camera at the origin of the world.
using EyeTriangle = std::array<Point<Eye>, 3>;
using Texcoords = std::array<std::array<float, 2>, 3>;
Vista vista_of(const std::vector<EyeTriangle>& triangles, const Lens& lens, int side);
// Each texel has a colour of its own. The nearest texel is shown, without levels of detail.
Vista textured_vista(const std::vector<EyeTriangle>& triangles,
                     const std::vector<Texcoords>& texcoords, const Lens& lens, int side,
                     std::array<int, 2> texels, Wrap wrap);
// Stripes one texel wide in red, four in green, sixteen in blue: the nearest level, box-filtered, has those that are left.
Vista striped_vista(const std::vector<EyeTriangle>& triangles,
                    const std::vector<Texcoords>& texcoords, const Lens& lens, int side,
                    int texels);
// All triangles of a scene.
Vista vista_of(const Scene& scene, const Camera& camera, int width, int height);

// Gives all triangles of such a vista, whose meshes lie in -1 .. 1 of x and y and are not mirrored, a texture over that square: each
// texel has a colour of its own, and the nearest is shown.
void lay_texels(Vista& vista, std::array<int, 2> texels);

// All triangles of a scene seen by a camera that is aimed, where 50 digits put them.
struct Aim {
  Point<World, double> eye, target;
  Vector<World, double> up;
};
Vista vista_of(const Scene& scene, const Aim& aim, const Lens& lens, int side);

// The view with the range of depth that the format takes.
void store_depth(Vista& vista, DepthFormat format);

// At a place in the world, looking along a gaze, 57 degrees wide, from 0.1 to 100 units away.
Camera camera_at(const Point<World, double>& place, const Vector<World, double>& gaze);

// Of a texel of a textured vista.
Rgba8 color_of_texel(int column, int row);

}  // namespace glassbox::study
