#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/vector_relational.hpp>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/bounds.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/pipeline/viewport.h>

#include "study/extremes/common/stereo_scene.h"
#include "study/extremes/sweep.h"

namespace glassbox::study {

namespace s8 {

constexpr double kWindow = 10;
using ClipFromEye = Transform<Clip, Eye, float>;

struct ScreenPosition {
  double x = 0, bound = 0;  // in px
};
// Projects a point and bounds the error of its x. `matrix_bound` is how far the entries of the
// matrix may be from the intended ones.
ScreenPosition project_with_bound(const View& view, const ClipFromEye& m,
                                  const glm::dmat4& matrix_bound, const Point<Eye>& p) {
  const Point<Clip> clip = m * p;
  const NdcVertex ndc = divide(clip);
  const glm::dvec4 clip_bound =
      transform_bound(m.columns, {p.x, p.y, p.z, 1}, glm::dvec4(0), matrix_bound);
  const glm::dvec3 screen =
      screen_bound(ndc.position, divide_bound(clip, clip_bound).position, view.viewport);
  return {double(to_screen(ndc, view.viewport).position.x), screen.x};
}

// The matrix of an eye, and how far its entries may be from those of the formula.
struct EyeMatrix {
  ClipFromEye matrix;
  glm::dmat4 bound{0};
};
EyeMatrix composed_in_double(const View& centre, const StereoPair& pair, Side side) {
  const View view = eye_view(centre, pair, side);
  return {round_to_float(view.clip_from_eye),
          rounding_bound(view.clip_from_eye.columns) +
              product_bound(centre.clip_from_eye.columns, stereo_skew(1, 1).columns) *
                  (1 + pair.half_separation)};
}
EyeMatrix composed_in_float(const View& centre, const StereoPair& pair, Side side) {
  const auto skew = stereo_skew(eye_shift(pair, side), pair.window);
  const auto a = round_to_float(centre.clip_from_eye);
  const Transform<Eye, Eye, float> b = round_to_float(skew);
  ClipFromEye m;
  m.columns = (a * b).columns;
  // The entries of the two matrices are rounded before (2 u, with the unit roundoff u), and the
  // product adds gamma_4, about 4 u: together 1.5 times the bound of a product. `product` is this
  // bound for double, so it is converted to the unit roundoff of float.
  const glm::dmat4 product = product_bound(glm::dmat4(a.columns), glm::dmat4(b.columns));
  return {m, product * (1.5 * double(unit_roundoff<float>) / unit_roundoff<double>)};
}

SweepSeries series_of(const char* name, bool ours,
                      EyeMatrix (*compose)(const View&, const StereoPair&, Side)) {
  const View centre = view_from_origin(1920, 1080);
  SweepSeries series{name, ours};
  for (int half = -12; half <= 2; ++half) {
    const double share = std::pow(10.0, half / 2.0);
    const StereoPair pair{share * kWindow / 2, kWindow};
    if (ours && !check_pair(centre, pair)) {
      series.points.push_back({share, std::numeric_limits<double>::infinity(), {}});
      continue;
    }
    SweepPoint worst{share, 0, 0};
    for (const float z : {-2.0f, -10.0f, -50.0f, -900.0f}) {
      const Point<Eye> p(z * 0.1f, z * 0.05f, z);
      const EyeMatrix left = compose(centre, pair, Side::kLeft);
      const EyeMatrix right = compose(centre, pair, Side::kRight);
      const ScreenPosition l = project_with_bound(centre, left.matrix, left.bound, p);
      const ScreenPosition r = project_with_bound(centre, right.matrix, right.bound, p);
      const double exact = parallax_at(centre, pair, -double(z)).px;
      worst.error = std::max(worst.error, std::abs(r.x - l.x - exact));
      worst.bound = std::max(*worst.bound, l.bound + r.bound);
    }
    series.points.push_back(worst);
  }
  return with_limit(std::move(series), 1.0 / 256);
}

std::vector<SweepSeries> separation_series() {
  return {series_of("composed in double, rounded once", true, composed_in_double),
          series_of("composed in float", false, composed_in_float)};
}

}  // namespace s8

Sweep s8_separation() {
  using namespace s8;
  return {
      .name = "separation",
      .title = "Separation of the eyes over the window's distance",
      .question = "For which separations does parallax follow the formula?",
      .axis = "separation over window distance",
      .error = "largest error of the parallax at 2 to 900, window at 10, 1920 px",
      .error_unit = "px",
      .reference = "2 s (d/h)(1/f - 1/z), computed to 5 ulps of double",
      .bound =
          "the error bounds of transform, divide and viewport, computed along with the numbers for "
          "both eyes (pipeline/bounds.h)",
      .tolerance =
          "an error of one step of the snap, 1/256 px, or a refusal; check_pair refuses eyes that "
          "are further apart than the picture is wide at the window",
      .series = separation_series};
}

}  // namespace glassbox::study
