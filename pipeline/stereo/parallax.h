// How far apart the two eyes see a point (S0-11): parallax, x in the right eye's picture minus x in the left one's.
// Negative is in front of the window (crossed), positive behind it.
//
//   perspective   p(z) = 2 s (d/h) (1/f - 1/z)      towards 2 s (d/h)/f at infinity
//   parallel      p(z) = 2 s (1/h) (z/f - 1)        linear, without limit
//
// in half-widths of the picture, with h the window's half-width at the distance d from the eye, s half the
// separation, f the stereo window's distance and z the point's, all along the gaze.
#pragma once

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

struct Parallax {
  double distance = 0;  // along the gaze, world units; may be infinite
  double half_widths = 0;
  double px = 0;
  double percent = 0;  // of the picture's width
};

// Within 5 ulps of the formula for z > 0 (perspective; infinity included) or any finite z (parallel); 0 exactly at the
// window.
Parallax parallax_at(const View& centre, const StereoPair& pair, double distance);

// The nearest, the undisturbed and the farthest: what the budget of comfort.h and the user's printout are about.
struct ParallaxTable {
  Parallax near, window, far;
};
ParallaxTable parallax_table(const View& centre, const StereoPair& pair);

// ---- in front of a display ----

// The distance between the pupils of a grown-up (the mean of men and women, to the next 5 mm). With more parallax than
// this behind the window, the eyes would have to diverge, which they cannot (C-72).
inline constexpr double kPupilDistanceMm = 65;

struct Display {
  double width_mm = 600;  // of the picture
  double viewing_distance_mm = 700;
};

struct DisplayedParallax {
  double mm = 0;
  // How much less the eyes converge than for the screen's surface: 2 atan(e/2D) - 2 atan((e - p)/2D).
  double degrees = 0;
  bool diverges = false;  // mm > kPupilDistanceMm
};
DisplayedParallax on_display(const Parallax& parallax, const Display& display);

// ---- cameras that are toed in (constructions.h) ----

// y in the left eye's picture minus y in the right one's, in pixels upwards, of a point of the centre's eye space for
// toe_in_view's cameras (S0-07):
//
//   -(d/h) y 2x sin(a) / (zL zR),  zL = z cos(a) + (x + s) sin(a),  zR = z cos(a) - (x - s) sin(a),  tan(a) = s/f
//
// Skewed frusta have none. 0 for parallel projections. Infinite or meaningless where a camera has the point beside or
// behind it.
double toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                   const Point<Eye, double>& point);

// The largest |vertical parallax| of what the centre's picture shows at this distance (may be infinite), which is
// that of one of its corners. It grows with the distance.
double largest_toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                           double distance);

}  // namespace glassbox
