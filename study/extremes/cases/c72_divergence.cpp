#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c72 {

constexpr Display kScreen{2000, 3000};
constexpr int kWidth = 1920;

// Returns half the separation of the eyes, for a window, the depths of a scene, and the parallax in
// px that is allowed behind the screen.
using Separation = double (*)(const View&, double window, const DepthSpan&, double budget_px);

Outcome measure_error(Separation separation) {
  const View centre = view_from_origin(kWidth, 1080, 0.1, std::numeric_limits<double>::infinity());
  const double budget_px = kPupilDistanceMm / kScreen.width_mm * kWidth;
  WorstError worst;
  int diverging = 0, tried = 0;
  for (const double window : {0.5, 1.0, 3.0, 10.0, 30.0}) {
    for (const double farthest : {2 * window, 100.0, std::numeric_limits<double>::infinity()}) {
      const DepthSpan span{0.8 * window, farthest};
      const StereoPair pair{separation(centre, window, span, budget_px), window};
      const DisplayedParallax shown =
          displayed_parallax(parallax_at(centre, pair, farthest), kScreen);
      diverging += shown.diverges;
      ++tried;
      worst.add(shown.mm, kPupilDistanceMm,
                fmt::format("parallax {:.1f} mm with the window at {}", shown.mm, window));
    }
  }
  return worst.outcome(fmt::format("eyes diverge in {} of {} scenes", diverging, tried));
}

double within_budget(const View& centre, double window, const DepthSpan& span, double budget_px) {
  return largest_half_separation(centre, window, span, {budget_px, budget_px});
}
double pupils(const View&, double, const DepthSpan&, double) {
  return kPupilDistanceMm / 2000;
}
double with_diameter_for_radius(const View& centre, double window, const DepthSpan& span,
                                double budget_px) {
  return 2 * within_budget(centre, window, span, budget_px);
}
double looking_in_front_only(const View& centre, double window, const DepthSpan& span,
                             double budget_px) {
  return largest_half_separation(centre, window, {span.nearest, window}, {budget_px, budget_px});
}

}  // namespace c72

ExtremeCase c72_divergence() {
  using namespace c72;
  return {
      .id = "C-72",
      .name = "Eyes that would have to diverge",
      .construction =
          "a screen 2 m wide, windows at 0.5 to 30, scenes that begin at 0.8 of the window's "
          "distance and end at twice this distance, at 100 or at infinity",
      .stage = "stereo",
      .right_answer =
          "the parallax of the farthest point on the screen is at most 65 mm, the distance of the "
          "pupils",
      .unit = "mm",
      .oracle = Oracle::kAnalytic,
      .ours = {"the largest separation within the budget",
               [] { return measure_error(within_budget); }},
      .naive = {"the eyes are as far apart as the pupils, 65 mm",
                [] { return measure_error(pupils); }},
      .mutants = {{"the whole separation instead of half of it",
                   [] { return measure_error(with_diameter_for_radius); }},
                  {"only points in front of the window are counted",
                   [] { return measure_error(looking_in_front_only); }}},
      .not_drawn =
          "the result is a separation of the eyes, which is chosen before anything is drawn; C-70 "
          "and C-73 test how pairs are drawn",
  };
}

}  // namespace glassbox::study
