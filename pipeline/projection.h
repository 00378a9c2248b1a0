// Eye space to clip space: every projection of the slides and of OpenGL, in one convention.
//
// Our convention: the eye looks down -z, clip w is the distance along the gaze (1 for parallel
// projections), depth is 0 at the near plane and 1 at the far one, or reversed. With n = near and f
// = far, the entries [2][2] and [2][3] are:
//
//                      standard                  reversed               far = infinity
//   perspective        -f/(f-n), -n f/(f-n)      n/(f-n), n f/(f-n)     -1, -n   or   0, n
//   parallel           -1/(f-n), -n/(f-n)        1/(f-n), f/(f-n)       (not possible)
//
// Every entry is within 4 ulps of its exact value for the given arguments, with no cancellation.
// Arguments that are powers of two give exact entries, and there is no -0. All matrices are in
// double: they are multiplied with the matrices of the stages before, and only the product is
// rounded to float.
#pragma once

#include <limits>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/dialects.h>

namespace glassbox {

// kStandard: depth 0 at the near plane, 1 at the far one. kReversed: 1 at the near plane, 0 at the
// far one, which gives floating-point depth nearly uniform relative precision (B.3).
enum class DepthRange { kStandard, kReversed };

// Distances of the planes in world units along the gaze (the slides' hither and yon). Perspective:
// 0 < near < far, far may be infinite. Parallel: any finite near < far.
struct DepthPlanes {
  double near = 0.1;
  double far = std::numeric_limits<double>::infinity();
  DepthRange range = DepthRange::kStandard;
};

// The edges of the picture in world units: on the near plane for perspective, at any depth for
// parallel projections. left < right and bottom < top; use a viewport to mirror a picture.
struct Window {
  double left = -1, right = 1, bottom = -1, top = 1;
};

// The matrix of gluPerspective (S4-12, S3-15): full vertical angle, aspect = width/height. Errors
// name the value: an angle outside (0, 180) degrees, an aspect that is not positive, planes out of
// order (C-08, C-09). The version in degrees is exact for 90.
Result<Transform<Clip, Eye>> perspective(double fovy_radians, double aspect, const DepthPlanes&);
Result<Transform<Clip, Eye>> perspective_degrees(double fovy_degrees, double aspect,
                                                 const DepthPlanes&);

// The matrix of glFrustum (S3-15, S4-12): a window on the near plane, which need not be centred.
Result<Transform<Clip, Eye>> frustum(const Window&, const DepthPlanes&);

// The matrix of glOrtho (S4-12).
Result<Transform<Clip, Eye>> orthographic(const Window&, const DepthPlanes&);

// How much a relative change of the field of view is magnified in the picture's scale: the
// condition number of cot(x/2), x/sin(x). It is 1 for narrow views and grows without limit towards
// 180 degrees (C-08).
double fov_condition(double fovy_radians);

// ---- the slides' own forms; multiply by eye_left_from_eye() on the right for our eye ----

// T_pers of S4.18-20: window half-height h on the view plane at distance d, which is also the near
// plane; far plane f (may be infinite): X = (d/h) x, Y = (d/h) y, Z = f (z - d)/(f - d), W = z.
Result<Transform<Clip, EyeLeft>> t_pers(double h, double d, double f);

// The form of S3.30-33: cot(theta) = d/s where theta is half the horizontal angle of view and s
// half the width of the window at the distance d (E13), aspect = ResX/ResY, alpha = yon/(yon -
// hither), beta = yon hither/(hither - yon), z' = alpha + beta/z.
Result<Transform<Clip, EyeLeft>> alpha_beta(double half_angle_degrees, double aspect, double hither,
                                            double yon);

// The form of S4.9: x_s = d x/z, y_s = d y/z after the divide by w = z/d. Every z becomes d.
Transform<Clip, EyeLeft> simple_perspective(double d);

// The form of S3.26: the same picture from diag(d, d, d, 0) with last row (0, 0, 1, 0). Its rank is
// 3: depth is lost, so it can project points but cannot decide which one is hidden (E15).
Transform<Clip, EyeLeft> singular_projection(double d);

// The form of S4.10: T_ort = diag(1, 1, 0, 1), which sets z to 0.
Transform<Clip, EyeLeft> drop_depth();

}  // namespace glassbox
