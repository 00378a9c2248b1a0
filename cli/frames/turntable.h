// A camera that goes round a scene once, so that the first picture can follow the last.
#pragma once

#include "cli/frames/camera_path.h"
#include "cli/options/camera_options.h"

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// A turn about the axis through `target` along `up`, counterclockwise as seen from the axis's tip.
struct Turntable {
  Point<World, double> target;
  Vector<World, double> from_target;  // to the eye in the first frame
  std::array<double, 3> up{0, 1, 0};

  // The camera of frame `number` (from 1) of `count`. It is turned by 360 (number - 1)/count
  // degrees; quarter turns are exact, because sin_cos_degrees is.
  CameraAt camera(int number, int count) const;
};

// Makes the turntable. The target is --look-at, or else the scene's centre. The eye starts at
// --eye, or else in the automatic camera's direction, so far away that everything is in every
// picture. --up and --fov are used; a camera of the scene is not.
Result<Turntable> make_turntable(const Scene& scene, const CameraOptions& options, double aspect);

}  // namespace glassbox
