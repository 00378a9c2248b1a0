// Other ways to construct the pair of eye_view, which is clip_from_eye * stereo_skew: two that give
// the same pair, the other reading of the slide's matrix, which gives the same pair with other
// parameters, and one that is wrong.
//
// For all of them the pair must have passed check_pair.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// The eye moves by -s (left) or s, where s is half the separation, then looks through an off-axis
// frustum: frustum() of projection.h for the centre's window on the near plane n, shifted by s n/f
// (left) or -s n/f, where f is the distance of the stereo window (S0-11). Errors: parallel
// projections, because glOrtho cannot slant its box, and a shifted window out of the range of
// double.
Result<View> off_axis_view(const View& centre, const StereoPair& pair, Side side);

// The eye moves by -s (left) or s, where s is half the separation, then eye space is sheared: x' =
// x - s z/f (left) or x + s z/f at the distance z, where f is the distance of the stereo window
// (S0-10, "translate and skew").
View translate_and_shear_view(const View& centre, const StereoPair& pair, Side side);

// ---- the slide's matrix after the projection (E2) ----

// x' = x + shift (1 - z/focus) in NDC, with the sign of `shift` changed for the right eye: the
// meaning of S0.21's product where vectors are rows. The plane without parallax is the one with the
// depth `focus`, 0 .. 1.
struct ClipSkew {
  double shift = 0, focus = 1;
};
View clip_skew_view(const View& centre, const ClipSkew& skew, Side side);

// Convert a StereoPair, for a skew in eye space, to a ClipSkew that gives the same pictures, and
// back. f is the distance of the stereo window, s half the separation, z' = A z_eye + B the third
// row of clip_from_eye and a its entry (0, 0):
//
//   perspective   f = B/(focus + A)     s = -shift B/(a focus)
//   parallel      f = (B - focus)/A     s = -shift A f/(a focus)
//
// It is an error if the window has depth 0 (on the near plane, or infinitely far in the reversed
// range), because then no ClipSkew gives the same pictures.
StereoPair pair_of_clip_skew(const View& centre, const ClipSkew& skew);
Result<ClipSkew> clip_skew_of_pair(const View& centre, const StereoPair& pair);

// ---- the wrong way ----

// Cameras that turn towards each other until their axes meet at the window: the tangent of the
// angle is half the separation over the window's distance. The corners of the picture get vertical
// parallax (parallax.h; S0-07, C-75), which eyes cannot follow, and the points without parallax are
// not on a plane.
View toe_in_view(const View& centre, const StereoPair& pair, Side side);

}  // namespace glassbox
