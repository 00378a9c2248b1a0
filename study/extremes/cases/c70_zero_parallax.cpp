#include <glassbox/base/random.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/stereo/parallax.h>

#include "study/extremes/common/attribute.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c70 {

constexpr StereoPair kPair{0.03, 10};
constexpr double kBound = 1.0 / 256;

// Returns the x of a point in one eye's picture, in px.
using XOf = std::function<double(Side, const Point<Eye>&)>;

// Tests a grid of points at the distance of the stereo window, over the whole picture.
Outcome measure_error(const XOf& x_of) {
  double worst = 0;
  int flipped = 0, points = 0;
  for (int i = -40; i <= 40; ++i) {
    for (int j = -20; j <= 20; ++j) {
      const Point<Eye> point(float(i) * 0.17f, float(j) * 0.19f, -10);
      const double left = x_of(Side::kLeft, point), right = x_of(Side::kRight, point);
      worst = std::max(worst, std::abs(right - left));
      flipped += snap(float(left)) != snap(float(right));
      ++points;
    }
  }
  return {worst,
          kBound,
          {},
          fmt::format("{} of {} points are snapped to different places for the two eyes", flipped,
                      points)};
}

View centre() {
  return view_from_origin(1920, 1080);
}

XOf through(const View& left, const View& right) {
  return [=](Side side, const Point<Eye>& point) {
    return double(project(side == Side::kLeft ? left : right, point).position.x);
  };
}

// Uses parallel cameras and moves the pictures by whole pixels until the parallax at the window is
// zero.
Outcome measure_parallax_error() {
  const StereoPair parallel{kPair.half_separation};
  const View left = eye_view(centre(), parallel, Side::kLeft);
  const View right = eye_view(centre(), parallel, Side::kRight);
  const double pushed = std::round(-parallax_at(centre(), parallel, kPair.window).px);
  return measure_error([=](Side side, const Point<Eye>& point) {
    return through(left, right)(side, point) + (side == Side::kRight ? pushed : 0);
  });
}

// Uses x' = x + s (1 + z/f), where z is the point's depth and f the window's distance: this sign is
// right only for an eye that looks along +z.
View with_sign_turned(Side side) {
  View view = eye_view(centre(), {kPair.half_separation}, side);
  const Transform<Eye, Eye> skew = stereo_skew(eye_shift(kPair, side), -kPair.window);
  view.clip_from_eye = centre().clip_from_eye * skew;
  return view;
}

// A mosaic in the plane of the window, made of triangles with corners at random places: each eye
// must see the same picture as the camera between the eyes.
RayScene mosaic() {
  Random random(70);
  constexpr int kCells = 8;
  Point<Eye> at[kCells + 1][kCells + 1];
  for (int i = 0; i <= kCells; ++i) {
    for (int j = 0; j <= kCells; ++j) {
      at[i][j] = {float(i - 4 + random.between(-0.3, 0.3)),
                  float(j - 4 + random.between(-0.3, 0.3)), -10};
    }
  }
  std::vector<EyeTriangle> triangles;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      triangles.push_back({at[i][j], at[i + 1][j], at[i + 1][j + 1]});
      triangles.push_back({at[i][j], at[i + 1][j + 1], at[i][j + 1]});
    }
  }
  return make_ray_scene(triangles, PerspectiveLens{0.785398163397448309616, 0.5, 1000.0}, 160);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference seen(mosaic());
  const StereoPair pair{0.3, 10};
  return worse_of(seen.measure_error(engine_for_eye(engine, pair, Side::kLeft)),
                  seen.measure_error(engine_for_eye(engine, pair, Side::kRight)));
}

}  // namespace c70

ExtremeCase c70_zero_parallax() {
  using namespace c70;
  return {
      .id = "C-70",
      .name = "Nothing moves in the stereo window",
      .construction = "3,321 points at the window's distance 10, half separation 0.03, 1920 x 1080",
      .stage = "stereo",
      .right_answer =
          "the parallax is 0, because matrices are composed in double and rounded once; the "
          "rounding of x in float changes a position by at most one step of the snap",
      .unit = "px",
      .oracle = Oracle::kAnalytic,
      .ours = {"skewed frusta",
               [] {
                 return measure_error(through(eye_view(centre(), kPair, Side::kLeft),
                                              eye_view(centre(), kPair, Side::kRight)));
               }},
      .naive = {"parallel cameras, whose pictures are shifted by whole pixels",
                measure_parallax_error},
      .mutants = {{"the skew has the wrong sign, that of a left-handed eye",
                   [] {
                     return measure_error(
                         through(with_sign_turned(Side::kLeft), with_sign_turned(Side::kRight)));
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
