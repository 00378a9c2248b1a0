// A camera that goes once around a scene: the last picture is followed by the first.
#pragma once

#include "app/frames/camera_path.h"
#include "app/options/camera_options.h"

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// About the axis through `target` along `up`, counterclockwise as seen from its tip.
struct Turntable {
  Point<World, double> target;
  Vector<World, double> from_target;  // to the eye of the first frame
  std::array<double, 3> up{0, 1, 0};

  // Of frame `number`, from 1, of `count`: 360 (number - 1)/count degrees round, which sin_cos_degrees has exactly at the
  // quarters.
  CameraAt camera(int number, int count) const;
};

// The target is --look-at, else the scene's centre. The eye begins at --eye, else where the automatic camera stands, but
// so far away that everything is in every picture. --up and --fov count; a camera of the scene does not.
Result<Turntable> make_turntable(const Scene& scene, const CameraOptions& options, double aspect);

}  // namespace glassbox::app
