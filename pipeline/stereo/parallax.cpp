#include <glassbox/pipeline/stereo/parallax.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/elementary.h>
#include <glassbox/base/trig.h>

namespace glassbox {
namespace {

// 1/f - 1/z, where either may be infinite. The difference z - f is taken before dividing, so that
// no digits cancel.
double inverse_difference(double f, double z) {
  if (std::isinf(z)) return 1 / f;
  if (std::isinf(f)) return -1 / z;
  return (z - f) / f / z;
}

// A point, given by the slopes x/z and y/z of its line of sight and by s/z, where s is half the
// separation. Points at infinity have these values, too.
struct LineOfSight {
  double x = 0, y = 0, half_separation = 0;
};

double toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                   const LineOfSight& line) {
  if (!centre.perspective) return 0;
  // The sine and cosine of the angle whose tangent is s/f.
  const double tangent = pair.half_separation / pair.window;
  const double cosine = 1 / hypotenuse(1, tangent), sine = tangent * cosine;
  const double left = cosine + (line.x + line.half_separation) * sine;  // zL/z, zL as in parallax.h
  const double right = cosine - (line.x - line.half_separation) * sine;  // zR/z
  const double half_heights =
      -centre.clip_from_eye.at(1, 1) * line.y * 2 * line.x * sine / (left * right);
  return half_heights * double(centre.viewport.height()) / 2;
}

}  // namespace

Parallax parallax_at(const View& centre, const StereoPair& pair, double distance) {
  const double scale = 2 * pair.half_separation * centre.clip_from_eye.at(0, 0);
  Parallax p;
  p.distance = distance;
  if (pair.half_separation == 0) return p;
  p.half_widths = scale * (centre.perspective ? inverse_difference(pair.window, distance)
                                              : (distance - pair.window) / pair.window);
  p.px = p.half_widths * double(centre.viewport.width()) / 2;
  p.percent = p.half_widths * 50;
  return p;
}

ParallaxTable parallax_table(const View& centre, const StereoPair& pair) {
  return {parallax_at(centre, pair, centre.near), parallax_at(centre, pair, pair.window),
          parallax_at(centre, pair, centre.far)};
}

DisplayedParallax displayed_parallax(const Parallax& parallax, const Display& display) {
  DisplayedParallax shown;
  shown.mm = parallax.percent / 100 * display.width_mm;
  const auto convergence = [&](double mm) {
    return 2 * arctan((kPupilDistanceMm - mm) / 2 / display.viewing_distance_mm);
  };
  shown.degrees = degrees_from_radians(convergence(0) - convergence(shown.mm));
  shown.diverges = shown.mm > kPupilDistanceMm;
  return shown;
}

double toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                   const Point<Eye, double>& point) {
  const double z = -point.z;
  return toe_in_vertical_parallax_px(
      centre, pair, LineOfSight{point.x / z, point.y / z, pair.half_separation / z});
}

double largest_toe_in_vertical_parallax_px(const View& centre, const StereoPair& pair,
                                           double distance) {
  double largest = 0;
  for (const double x_ndc : {-1.0, 1.0}) {
    for (const double y_ndc : {-1.0, 1.0}) {
      // The projection has x_clip = a x + b z_eye and w = -z_eye, so the distance z = -z_eye gives
      // x/z = (x_ndc + b)/a.
      const LineOfSight corner{
          (x_ndc + centre.clip_from_eye.at(0, 2)) / centre.clip_from_eye.at(0, 0),
          (y_ndc + centre.clip_from_eye.at(1, 2)) / centre.clip_from_eye.at(1, 1),
          pair.half_separation / distance};
      largest = std::max(largest, std::abs(toe_in_vertical_parallax_px(centre, pair, corner)));
    }
  }
  return largest;
}

}  // namespace glassbox
