// A ray scene is a scene with everything that is needed to say what is visible in it: the lens, and
// every triangle in eye space.
#pragma once

#include <array>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

struct ExactEyeTriangle {
  std::array<std::array<long double, 3>, 3> corners{};  // in eye space
  std::array<std::array<double, 2>, 3> texcoords{};
};

// A scene, its lens, view and settings, and the scene's triangles in eye space, in the scene's
// order.
struct RayScene {
  Scene scene;
  Lens lens;
  View view;
  RenderSettings settings;
  std::vector<ExactEyeTriangle> triangles;
  // If the distances of two surfaces differ by a smaller fraction than this, either of them may be
  // visible.
  double separation = 1e-3;
  // What pixels must show in addition to the nearest triangle: its texel at this place, or its
  // level of detail.
  enum class Texels { kNone, kEach, kLevels } texels = Texels::kNone;
};

// A ray scene of triangles, given as the floats that the pipeline gets; the camera is at the origin
// of the world.
using EyeTriangle = std::array<Point<Eye>, 3>;
using Texcoords = std::array<std::array<float, 2>, 3>;
RayScene make_ray_scene(const std::vector<EyeTriangle>& triangles, const Lens& lens, int side);
// A ray scene in which each texel has a colour of its own. The nearest texel is shown, without
// mipmaps.
RayScene textured_ray_scene(const std::vector<EyeTriangle>& triangles,
                            const std::vector<Texcoords>& texcoords, const Lens& lens, int side,
                            std::array<int, 2> texels, Wrap wrap);
// A ray scene whose texture has stripes one texel wide in red, four texels wide in green, sixteen
// in blue. The nearest box-filtered mipmap level is shown; it still has the stripes that are wide
// enough.
RayScene striped_ray_scene(const std::vector<EyeTriangle>& triangles,
                           const std::vector<Texcoords>& texcoords, const Lens& lens, int side,
                           int texels);
// A ray scene of all triangles of a scene.
RayScene make_ray_scene(const Scene& scene, const Camera& camera, int width, int height);

// Gives all triangles of a ray scene a texture over the square -1 .. 1 in x and y, where its meshes
// must be; they must not be mirrored. Each texel has a colour of its own, and the nearest texel is
// shown.
void add_numbered_texels(RayScene& ray_scene, std::array<int, 2> texels);

// A camera that is aimed at a target, for a ray scene of all triangles of a scene; their places in
// eye space are computed with 50 digits.
struct Aim {
  Point<World, double> eye, target;
  Vector<World, double> up;
};
RayScene make_ray_scene(const Scene& scene, const Aim& aim, const Lens& lens, int side);

// Changes the view to the depth range that the format needs.
void store_depth(RayScene& ray_scene, DepthFormat format);

// A camera at a place in the world that looks along `gaze`, with an angle of view of 57 degrees, a
// near plane at 0.1 and a far plane at 100.
Camera camera_at(const Point<World, double>& place, const Vector<World, double>& gaze);

// The colour of a texel of a textured ray scene.
Rgba8 color_of_texel(int column, int row);

}  // namespace glassbox::study
