// Two eyes with parallel axes (S0-07, S0-11), whose frusta are skewed so that both pictures show
// the same window.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

enum class Side { kLeft, kRight };

// The positions of the eyes around the centre camera, in world units. The left eye is
// `half_separation` to the left of it and the right eye as far to the right. A point at the
// distance `window` along the gaze has no parallax; a nearer point appears in front of the screen,
// a farther one behind it.
//
// An infinite window gives the naive pair of S0-08, parallel cameras without skew: everything
// appears in front of the screen.
struct StereoPair {
  double half_separation = 0;
  double window = std::numeric_limits<double>::infinity();
};

// The distance by which an eye shifts the world along x: positive for the left eye, negative for
// the right one.
inline double eye_shift(const StereoPair& pair, Side side) {
  return side == Side::kLeft ? pair.half_separation : -pair.half_separation;
}

// Half of the picture's width at the distance `window`, in world units; at the far plane where the
// window is infinitely far. It is the largest half separation that check_pair allows.
double window_half_width(const View& centre, double window);

// Checks that the pair makes sense with this camera (a View of make_view). Zero separation does:
// both eyes see the same picture, and `window` is not read. Errors, with a remedy:
//   - numbers that are not finite (but an infinite window is allowed with perspective); a negative
//     separation, which exchanges the eyes;
//   - a window that is not in front of the camera, nearer than the near plane, or beyond the far
//     plane;
//   - eyes that are further apart than the picture is wide at the window (with an infinite window:
//     at the far plane). From this separation on, the two pictures of infinity have nothing in
//     common. The usual separation, a thirtieth of the window's distance, is some fifty times less;
//   - entries of the eyes' matrices that float cannot hold.
Result<void> check_pair(const View& centre, const StereoPair& pair);

// The centre's view with clip_from_eye * stereo_skew(s, f), where s is half the separation for the
// left eye, minus that for the right eye, and f is the window's distance: x' = x + s (1 - z/f) at
// the distance z. Everything else is equal to the centre's, bit for bit: eye space, so that
// lighting is the same for both eyes, and the rows y, z, w of clip_from_eye (S0-03). Zero
// separation returns the centre's view. The pair must have passed check_pair.
//
// With a parallel projection the two views are oblique: their lines of sight are parallel to the
// lines from the eyes, (-s, 0) and (s, 0) in x and z, to the window's centre (0, f), and parallax
// grows linearly with depth, without limit (parallax.h). A distant pair of cameras with long lenses
// would see the same, so the depths of the near and far plane should be of the same order as the
// window's.
View eye_view(const View& centre, const StereoPair& pair, Side side);

}  // namespace glassbox
