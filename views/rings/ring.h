// The cameras from which the pictures of a ring are taken: on circles around an axis through a
// target, all looking at it (S1-29).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

#include "views/files/camera_file.h"

namespace glassbox::views {

struct RingOptions {
  int views = 21;                      // on each circle
  std::vector<double> elevations{20};  // degrees above the target's plane, one circle for each
  // An arc of 360: the cameras are evenly around; less: from one end of the arc to the other, with
  // a camera at each end.
  double arc_degrees = 360, start_degrees = 0;
  double fov_degrees = 30;        // full vertical angle
  int width = 320, height = 320;  // px
  std::optional<double>
      distance;  // world units; absent: chosen so that the whole scene is in every picture
  std::optional<Vector3d> target;  // absent: the centre of what is drawn
  Vector3d up{0, 1, 0};
  std::optional<double> pair_separation;  // world units: two cameras at each place, this far apart
};

// One picture to take: its camera in the form that the engine uses (view), and as a pinhole camera
// for the geometry of pictures (named).
struct RingView {
  NamedCamera named;
  View view;
};

// The bounding box of what is drawn: its corners with the least and the greatest coordinates.
struct WorldBox {
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
};
WorldBox box_of(const Scene& scene);
std::array<Vector3d, 8> corners_of(const WorldBox& box);

inline constexpr int kMaxRingViews = 512;

// The views are named "view000.png", "view001.png"; with pairs "view000_left.png". Refused: a scene
// that draws nothing, numbers out of range, `up` parallel to a direction of view.
Result<std::vector<RingView>> ring_views(const Scene& scene, const RingOptions& options);

// The engine's view for a pinhole camera. `near` and `far` are distances in world units along the
// direction of view; a skewed K is refused.
Result<View> view_of(const PinholeCamera& camera, int width, int height, double near, double far);

// The engine's view for a camera, with near and far planes that enclose the box. At least a part of
// the box must be in front of the camera.
Result<View> view_of(const PinholeCamera& camera, int width, int height, const WorldBox& box);

}  // namespace glassbox::views
