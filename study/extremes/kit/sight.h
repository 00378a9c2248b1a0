// What is seen through a point of the screen, worked out along the line of sight in extended precision: no matrix, no
// clipping, no divide, no snap and no interpolation, so that it shares nothing with what draws.
//
// Vertices are drawn where they are snapped to and screen coordinates are floats, so the right answer belongs to a picture
// whose edges may be moved by some 2^-7 px (C-40 has the sum). A pixel is judged where its centre and eight points 2^-7 px
// around it see the same.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "study/extremes/kit/drawer.h"
#include "study/extremes/kit/extreme_case.h"

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
  double separation =
      1e-3;  // surfaces whose distances differ by less, relatively, may hide each other
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

// At a place in the world, looking along a gaze, 57 degrees wide, from 0.1 to 100 units away.
Camera camera_at(const Point<World, double>& place, const Vector<World, double>& gaze);

// Through a point, in pixels.
struct Sight {
  int layers = 0;   // surfaces that are hit, those that are culled apart
  int nearest = 0;  // 1 + the number of the first; 0: none
  std::array<int, 2> texel{};
  int stripes = 0;         // of the three kinds, how many the level has lost
  bool told_apart = true;  // the nearest from the next
  friend bool operator==(const Sight&, const Sight&) = default;
};
// `candidates`: numbers of the triangles that may be hit, ascending.
Sight sight_at(const Vista& vista, std::span<const std::size_t> candidates, double x, double y);

// A vista and what is seen of it, worked out once for all drawers.
class SightDrawn {
public:
  explicit SightDrawn(Vista vista);
  // Pixels that show another triangle or texel, and those that are covered by another number of layers. Infinite where fewer
  // than half of the pixels can be judged.
  Outcome judge(const Drawer& drawer) const;

private:
  Vista vista_;
  // Of a pixel; none: not to be judged.
  struct Pixel {
    std::optional<Sight> sight;
    std::optional<int> layers;  // known beside an edge that two triangles share, too
  };
  std::vector<Pixel> pixels_;  // by rows
};

// The worst of several pictures.
Outcome worst_of(const std::vector<SightDrawn>& pictures, const Drawer& drawer);

}  // namespace glassbox::study
