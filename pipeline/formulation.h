// The slides' ways to the two matrices of a view, beside the program's own: the same maps by other arithmetic.
//
//   eye_from_world   kUvn           [U; V; N] T(-eye), what gluLookAt makes (S4-02, S4-03)
//                    kAxisAngle     R_z(roll) R(a, theta) T(-eye) (S3-16)
//   clip_from_eye    kPerspective   by the vertical angle, what gluPerspective makes (S4-12); other lenses as they are
//                    kFrustum       by the window on the near plane, what glFrustum makes (S3-15)
//                    kTPers         by the window's half-height on the view plane, which is the near plane (S4-10)
//                    kAlphaBeta     by half the horizontal angle, and z' = alpha + beta/z (S3-12, S3-14)
//
// In double, entries of the rotation are within 16 u of each other. So are those of clip_from_eye but for rounding: 12 ulps,
// and for kAlphaBeta, whose angle is rounded, 4 times fov_condition() of the horizontal angle more. Rounded to float most
// entries are the same, and the rest are neighbours.
#pragma once

#include <optional>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/axis_angle.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

enum class ViewForm { kUvn, kAxisAngle };
enum class ProjectionForm { kPerspective, kFrustum, kTPers, kAlphaBeta };

struct Formulation {
  ViewForm view = ViewForm::kUvn;
  ProjectionForm projection = ProjectionForm::kPerspective;
  friend bool operator==(const Formulation&, const Formulation&) = default;
};

// make_view with the matrices made these ways. Errors, besides its own: a projection form other than kPerspective for a
// parallel lens; kTPers and kAlphaBeta with reversed depth, or with a window that is not centred on the gaze.
Result<View> make_view(const Camera& camera, int width, int height, DepthRange depth_range,
                       const Formulation& formulation);

// ---- the factors, for whoever wants to look at them ----

// The factors of kAxisAngle. The pose is rigid.
AxisAngleFactors axis_angle_factors(const Transform<World, Eye>& world_from_eye);

// Between the scale and the box: the viewing pyramid with a right angle at its top, |x|, |y| <= z.
struct RegularPyramid {};

// S4.18-20: a perspective matrix as what happens to the slides' left-handed eye, one step after the other. The product
// clip_from_pyramid * moved * scaled * eye_left_from_eye() is clip_from_eye bit for bit.
struct PerspectiveFactors {
  // diag(d/h, d/h, 1, 1), or with one scale for each of x and y.
  Transform<RegularPyramid, EyeLeft> scaled;
  // The identity, but for windows beside the gaze, and a pair's eyes.
  Transform<RegularPyramid, RegularPyramid> moved;
  // The pyramid to the box: x, y stay, depth and w follow.
  Transform<Clip, RegularPyramid> clip_from_pyramid;
  bool has_moved = false;
};

// Nothing for matrices that are no perspective of projection.h's form.
std::optional<PerspectiveFactors> perspective_factors(const Transform<Clip, Eye>& clip_from_eye);

}  // namespace glassbox
