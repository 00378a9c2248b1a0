// Draws a scene with the matrices of somebody else's program: turns a view and a projection, in the
// conventions of any graphics API, into the View that the stages need.
//
// Clip coordinates stay those of the given matrices, up to the API's clip space: the product of the
// result's matrices is C P V / k, where C converts the clip space (depth -1 .. 1 to 0 .. 1,
// reversed depth, y that points down) and k > 0 makes w the distance along the gaze. So the picture
// is the one that the API would draw.
//
// Eye space is the given one if the view is a rotation and a translation and the projection looks
// along an axis: as it is if it looks along -z, and mirrored in z if it looks along +z. Otherwise
// (the view scales or shears, or --proj has a view in it) the eye is found in the product P V: it
// is the point where x, y and w are 0, its gaze is the direction in which w grows, and its right
// axis lies in the picture's rows. All computation is in double.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/matrices/matrix_setup.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

struct MatrixView {
  MatrixSetup setup;  // the matrices as they were given
  View view;
  // The same eye as a camera, for reports: its lens has the window and the planes of the projection
  // where it is not sheared.
  Camera camera;
  bool mirrors = false;             // whether the picture is a mirror image of the world
  bool eye_space_is_given = true;   // false: the eye was found in the product P V
  bool looks_along_plus_z = false;  // of the given eye space; if true, it was mirrored in z
  // From the clip space of the API to ours, in words; empty if they are the same.
  std::string conversion;
};

// The view for a picture of `width` x `height` pixels whose depth buffer expects `range`. Errors:
// an entry that is not finite or too large for float, a product P V that flattens the world onto a
// line or a point, an illegal size.
Result<MatrixView> view_of_matrices(const MatrixSetup& setup, int width, int height,
                                    DepthRange range);

// The width divided by the height of the window that the projection is made for; nothing if the
// projection does not scale x and y, or is sheared.
std::optional<double> aspect_of_projection(const GivenMatrix& projection);

}  // namespace glassbox
