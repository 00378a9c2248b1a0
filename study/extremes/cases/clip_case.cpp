#include "study/extremes/cases/clip_case.h"

#include <cmath>

namespace glassbox::study {

double area_error(const Outline& outline, const ClipTriangle& triangle,
                  std::span<const ClipPlane> planes) {
  using exact::Rational;
  for (const Point<Clip>& p : outline) {
    if (p.w == 0 || !std::isfinite(p.x + p.y + p.z + p.w)) return HUGE_VAL;
  }
  const auto exact = exact::clip(exact::exact_polygon<Rational>(triangle), planes);
  const Rational difference =
      exact::twice_ndc_area(exact_outline(outline)) - exact::twice_ndc_area(exact);
  return double(abs(difference));
}

}  // namespace glassbox::study
