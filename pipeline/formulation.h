// The slides' ways to compute the two matrices of a view, beside the program's own: the same maps
// by different arithmetic.
//
//   eye_from_world  kUvn          [U; V; N] T(-eye), as in gluLookAt (S4-02, S4-03)
//                   kAxisAngle    R_z(roll) R(a, theta) T(-eye) (S3-16)
//   clip_from_eye   kPerspective  from the vertical angle, as in gluPerspective (S4-12);
//                                 other lenses are unchanged
//                   kFrustum      from the window on the near plane, as in glFrustum (S3-15)
//                   kTPers        from the window's half-height on the view plane, which is
//                                 the near plane (S4-10)
//                   kAlphaBeta    from half the horizontal angle, and z' = alpha + beta/z
//                                 (S3-12, S3-14)
//
// In double, the entries of the rotations differ by at most 16 u (u is the unit roundoff, 2^-53).
// The entries of clip_from_eye differ only by rounding: by 12 ulps, and for kAlphaBeta, whose angle
// is rounded, by 4 times fov_condition() of the horizontal angle more. After rounding to float most
// entries are equal, and the rest are neighbouring floats.
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

// make_view with its matrices computed as `formulation` says. Errors, besides those of make_view: a
// projection form other than kPerspective for a parallel lens; kTPers and kAlphaBeta with reversed
// depth, or with a window that is not centred on the gaze.
Result<View> make_view(const Camera& camera, int width, int height, DepthRange depth_range,
                       const Formulation& formulation);

// ---- the factors of the matrices, to be shown one by one ----

// The factors of kAxisAngle. The pose must be rigid.
AxisAngleFactors axis_angle_factors(const Transform<World, Eye>& world_from_eye);

// The space after PerspectiveFactors::scale and before its clip_from_pyramid: there the viewing
// pyramid has a right angle at its top, |x|, |y| <= z.
struct RegularPyramid {};

// A perspective matrix as a sequence of steps for the slides' left-handed eye (S4.18-20). The
// product clip_from_pyramid * shear * scale * eye_left_from_eye() is clip_from_eye bit for bit.
struct PerspectiveFactors {
  // diag(d/h, d/h, 1, 1), where h is the half-height of the window at the distance d, or different
  // scales for x and y.
  Transform<RegularPyramid, EyeLeft> scale;
  // The identity, unless the window is not centred on the gaze or the view is an eye of a stereo
  // pair.
  Transform<RegularPyramid, RegularPyramid> shear;
  // Maps the pyramid to clip space: x and y do not change, depth and w are computed.
  Transform<Clip, RegularPyramid> clip_from_pyramid;
  bool has_shear = false;
};

// Returns nothing for matrices that are not a perspective of the form in projection.h.
std::optional<PerspectiveFactors> perspective_factors(const Transform<Clip, Eye>& clip_from_eye);

}  // namespace glassbox
