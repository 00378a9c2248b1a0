// Parallax, the distance between a point's two images (S0-11): x in the right eye's picture minus x
// in the left one's. It is negative in front of the window (crossed) and positive behind it.
//
//   perspective   p(z) = 2 s (d/h) (1/f - 1/z)      towards 2 s (d/h)/f at infinity
//   parallel      p(z) = 2 s (1/h) (z/f - 1)        linear, without limit
//
// in half-widths of the picture, with h the window's half-width at the distance d from the eye, s
// half the separation, f the stereo window's distance and z the point's, all along the gaze.
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

// The parallax at a distance, within 5 ulps of the formula for z > 0 (perspective; infinity
// included) or any finite z (parallel); exactly 0 at the window.
Parallax parallax_at(const View& centre, const StereoPair& pair, double distance);

// The parallax at the near plane, at the window and at the far plane: the values that the budget of
// parallax_budget.h and the user's printout use.
struct ParallaxTable {
  Parallax near, window, far;
};
ParallaxTable parallax_table(const View& centre, const StereoPair& pair);

// ---- in front of a display ----

// The distance between an adult's pupils (the mean of men and women, rounded to 5 mm). With more
// parallax than this behind the window, the eyes would have to diverge, which they cannot (C-72).
inline constexpr double kPupilDistanceMm = 65;

struct Display {
  double width_mm = 600;  // of the picture
  double viewing_distance_mm = 700;
};

struct DisplayedParallax {
  double mm = 0;
  // The decrease of the eyes' convergence, compared with a point on the screen: 2 atan(e/2D) - 2
  // atan((e - p)/2D), where e is the distance between the pupils, D the viewing distance and p the
  // parallax in mm.
  double degrees = 0;
  bool diverges = false;  // mm > kPupilDistanceMm
};
DisplayedParallax displayed_parallax(const Parallax& parallax, const Display& display);

// ---- cameras that are toed in (constructions.h) ----

// y in the left eye's picture minus y in the right one's, in pixels upwards, for a point of the
// centre's eye space seen by toe_in_view's cameras (S0-07):
//
//   -(d/h) y 2x sin(a) / (zL zR),  tan(a) = s/f,
//   zL = z cos(a) + (x + s) sin(a),  zR = z cos(a) - (x - s) sin(a)
//
// with the point's coordinates x, y, z (z along the gaze) and the other letters of the comment at
// the top of this file. Skewed frusta have no vertical parallax. The result is 0 for parallel
// projections, and infinite or meaningless where the point is beside or behind a camera.
double toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                   const Point<Eye, double>& point);

// The largest |vertical parallax| that toe_in_view's cameras give in the centre's picture at this
// distance (may be infinite); it occurs at one of the corners. It grows with the distance.
double largest_toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                           double distance);

}  // namespace glassbox
