#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c107 {

using Triangulation = views::Triangulated (*)(const views::Match&, const views::StereoRig&);

// Whether the point is classified correctly as behind the cameras, infinitely far away or in front
// of them.
bool is_right(const views::Triangulated& found, double disparity) {
  if (!found.point.allFinite()) return false;
  if (disparity == 0) return !found.is_finite() && found.in_front_of_both;
  if (disparity < 0) return found.is_finite() && !found.in_front_of_both;
  const double depth = 800 * 0.1 / disparity;
  // The bound has the unit roundoff u = 2^-53. Calibrated points are right to 4 u, and the
  // disparity is the difference of two of them, numbers of about 100 px.
  const double bound = 64 * 0x1p-53 * depth * (1 + 100 / disparity);
  return found.in_front_of_both && std::abs(found.point.z() - depth) <= bound;
}

Outcome measure_error(Triangulation triangulation) {
  int wrong = 0, tried = 0;
  for (const double disparity : {40.0, 1.0, 0.015625, 0.0, -0.015625, -1.0, -40.0}) {
    for (const double x : {320.0, 400.0, 37.5}) {
      const views::Match pixels{{x, 100}, {x - disparity, 100}};
      wrong += !is_right(triangulation(pixels, rig_at({0.1, 0, 0})), disparity);
      ++tried;
    }
  }
  // If the cameras are turned, two parallel lines of sight have directions that differ by rounding
  // errors.
  Random random(107);
  for (int i = 0; i < 20; ++i) {
    views::StereoRig rig = random_rig(random);
    const views::Vector3d far = 1e3 * random_visible_point(random, rig, 2, 10);
    const views::Vector3d centre = rig.pose.translation;
    rig.pose.translation.setZero();
    const views::Match pixels = project_match(rig, far);
    rig.pose.translation = centre;
    wrong += !is_right(triangulation(pixels, rig), 0);
    ++tried;
  }
  return wrong_count_outcome(wrong, tried, "points are wrong");
}

views::Triangulated flagged(const views::Match& pixels, const views::StereoRig& rig) {
  return views::triangulate(views::Triangulator::kMidpoint, pixels, rig);
}
views::Triangulated never_at_infinity(const views::Match& pixels, const views::StereoRig& rig) {
  const views::Triangulated found = flagged(pixels, rig);
  return found.is_finite() ? found : naive::by_division(pixels, rig);
}
views::Triangulated at_infinity_too_soon(const views::Match& pixels, const views::StereoRig& rig) {
  views::Triangulated found = flagged(pixels, rig);
  if (found.point.head<3>().norm() > 1e3) {
    found.point.w() = 0;
    found.in_front_of_both = true;
  }
  return found;
}

}  // namespace c107

ExtremeCase c107_parallel_rays() {
  using namespace c107;
  return {
      .id = "C-107",
      .name = "Parallel lines of sight",
      .construction =
          "disparities from 40 px to -40 px with a 0 in between, focal length 800 px, baseline "
          "0.1; 20 pairs of turned cameras that see infinitely far points",
      .stage = "two views",
      .right_answer =
          "for a disparity d above 0 the depth is f B/d; for 0 the result is a direction with w = "
          "0; below 0 it is a point that is reported as behind the cameras; lines count as "
          "parallel if the sine of their angle is below 8 u",
      .unit = "points",
      .oracle = Oracle::kAnalytic,
      .ours = {"the midpoint, and a flag for points at infinity",
               [] { return measure_error(flagged); }},
      .naive = {"the quotient f B/d, without a test",
                [] { return measure_error(naive::by_division); }},
      .mutants = {{"a division by 0 for parallel lines",
                   [] { return measure_error(never_at_infinity); }},
                  {"everything beyond 1000 counts as infinitely far",
                   [] { return measure_error(at_infinity_too_soon); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
