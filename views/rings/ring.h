// Where the pictures of a ring are taken from: cameras on circles around an axis through a target, all looking at it (S1-29).
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
  int views = 21;                      // of each circle
  std::vector<double> elevations{20};  // degrees above the target's plane, a circle for each
  double arc_degrees = 360,
         start_degrees = 0;       // 360: evenly around; less: from end to end, both included
  double fov_degrees = 30;        // full vertical angle
  int width = 320, height = 320;  // px
  std::optional<double>
      distance;  // world units; absent: so that all of the scene is in every picture
  std::optional<Vector3d> target;  // absent: the centre of what is drawn
  Vector3d up{0, 1, 0};
  std::optional<double> pair_separation;  // world units: two cameras in each place, so far apart
};

// One picture to take: its camera as the engine has it, and as the geometry of pictures has it.
struct RingView {
  NamedCamera named;
  View view;
};

// The box of what is drawn: corners of least and greatest coordinates.
struct WorldBox {
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
};
WorldBox box_of(const Scene& scene);
std::array<Vector3d, 8> corners_of(const WorldBox& box);

inline constexpr int kMostRingViews = 512;

// Named "view000.png", "view001.png"; of pairs "view000_left.png". Refused: nothing drawn, numbers out of range, `up` along a gaze.
Result<std::vector<RingView>> ring_views(const Scene& scene, const RingOptions& options);

// A camera of the geometry as the engine draws with it. `near` and `far` in world units along the gaze; a skewed K is refused.
Result<View> view_of(const PinholeCamera& camera, int width, int height, double near, double far);

// The same, with planes that hold the box; the box must be before the camera.
Result<View> view_of(const PinholeCamera& camera, int width, int height, const WorldBox& box);

}  // namespace glassbox::views
