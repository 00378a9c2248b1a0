// From a camera, which is data, to the matrices that the stages apply.
#pragma once

#include <limits>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// kStandard: depth 0 at the near plane, 1 at the far one. kReversed: 1 at the near plane, 0 at the far one, which
// gives floating-point depth nearly uniform relative precision (SPEC B.3).
enum class DepthRange { kStandard, kReversed };

// One way of looking at a scene: everything the geometric stages need besides the scene.
struct View {
  Transform<Eye, World> eye_from_world;  // rigid
  Transform<Clip, Eye> clip_from_eye;
  Viewport viewport;
  DepthRange depth_range = DepthRange::kStandard;
  bool perspective = true;  // false: parallel projection, w = 1 everywhere
  double near = 0.1;        // world units along the gaze
  double far = std::numeric_limits<double>::infinity();
};

// Checks the camera (near > 0 for perspective, near < far, 0 < fovy < 180 degrees, a rigid pose, all numbers finite)
// and composes its matrices for an image of `width` x `height` pixels. Errors name the offending value and the
// remedy.
Result<View> make_view(const Camera& camera, int width, int height,
                       DepthRange depth_range = DepthRange::kStandard);

}  // namespace glassbox
