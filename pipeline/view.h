// Converts a camera, which is data, to the matrices that the stages apply.
#pragma once

#include <limits>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// One way of looking at a scene: all data that the geometric stages need besides the scene.
struct View {
  Transform<Eye, World> eye_from_world;  // rigid
  Transform<Clip, Eye> clip_from_eye;
  Viewport viewport;
  DepthRange depth_range = DepthRange::kStandard;
  bool perspective = true;  // false: parallel projection, w = 1 everywhere
  double near = 0.1;        // world units along the gaze
  double far = std::numeric_limits<double>::infinity();
  // Whether the front faces of a model that is not mirrored run clockwise on the screen. They do if
  // the view's matrices mirror the world, or if a graphics API is set so.
  bool front_clockwise = false;
};

// Images have 1 .. kMaxImageSide pixels in each direction.
inline constexpr int kMaxImageSide = 16384;

// A pose whose axes deviate from perpendicular unit vectors by at most this much (the largest entry
// of R^T R - I) is treated as a rotation given with few digits and replaced by the nearest rotation
// (C-12); a larger deviation is an error. Poses with a deviation of at most 16 u (u is the unit
// roundoff, 2^-53) are used unchanged.
inline constexpr double kRigidTolerance = 0x1p-10;

// An error unless both sides have 1 .. kMaxImageSide pixels.
Result<void> check_picture_size(int width, int height);

// Checks the camera (near > 0 for perspective, near < far, 0 < fovy < 180 degrees, a rigid pose,
// all numbers finite) and composes its matrices for an image of `width` x `height` pixels. Errors
// name the offending value and the remedy. Numbers that would overflow or become 0 when the matrix
// is rounded to float are errors too.
Result<View> make_view(const Camera& camera, int width, int height,
                       DepthRange depth_range = DepthRange::kStandard);

}  // namespace glassbox
