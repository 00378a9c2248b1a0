#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c103 {

// Points on the quadric x^2 - x + y z = 0. It is a critical surface, because it is ruled (made of
// straight lines) and contains both camera centres, (0, 0, 0) and (1, 0, 0).
views::Matches on_quadric(Random& random, const views::StereoRig& rig, double sigma) {
  views::Matches pixels;
  while (pixels.size() < 60) {
    const double x = random.between(-1.5, 2.5), z = random.between(4, 8);
    pixels.push_back(project_match(rig, {x, (x - x * x) / z, z}, sigma, random));
  }
  return pixels;
}

struct DecisionInput {
  views::PairClassification judged;
  int rank = 0;
};
using Decision = views::PairKind (*)(const DecisionInput&);

views::PairKind by_gap(const DecisionInput& asked) {
  return asked.judged.kind;
}
views::PairKind eight_points_do(const DecisionInput& asked) {
  return naive::always_general(asked.judged);
}
// Recognises a critical surface by a rank below 8. This fails with noise, because the rank is then
// full.
views::PairKind by_rank(const DecisionInput& asked) {
  return asked.rank < 8 ? views::PairKind::kCritical : views::PairKind::kGeneral;
}
// Tests only for homographies. Points on a critical surface satisfy none, so such a pair of cameras
// counts as general.
views::PairKind by_homography(const DecisionInput& asked) {
  return asked.judged.kind == views::PairKind::kCritical ? views::PairKind::kGeneral
                                                         : asked.judged.kind;
}

Outcome measure_error(Decision decision) {
  Random random(103);
  int wrong = 0, tried = 0;
  const views::StereoRig rig = rig_at({1, 0, 0});
  for (int i = 0; i < 10; ++i) {
    for (const double sigma : {0.0, 0.1}) {
      for (const bool critical : {true, false}) {
        const views::Matches pixels =
            critical ? on_quadric(random, rig, sigma) : matches_of(random, rig, 60, sigma, 3, 8);
        const auto judged = views::classify_pair(pixels, rig.left_intrinsic, rig.right_intrinsic,
                                                 sigma > 0 ? sigma : 0.1);
        const int rank = views::linear_fit(views::normalised(pixels)->matches)->rank();
        const auto right = critical ? views::PairKind::kCritical : views::PairKind::kGeneral;
        wrong += !judged || decision({*judged, rank}) != right;
        ++tried;
      }
    }
  }
  return wrong_count_outcome(wrong, tried, "pairs of cameras are reported wrongly");
}

}  // namespace c103

ExtremeCase c103_critical_surface() {
  using namespace c103;
  return {
      .id = "C-103",
      .name = "Points on a ruled quadric",
      .construction =
          "60 points and both centres on x^2 - x + y z = 0, without noise and with 0.1 px; the "
          "same "
          "cameras before any points",
      .stage = "two views",
      .right_answer =
          "a second matrix satisfies all equations: the eighth singular value is as small as the "
          "ninth, or nearly, and no homography fits",
      .unit = "pairs",
      .oracle = Oracle::kAnalytic,
      .ours = {"the gap between the last two singular values",
               [] { return measure_error(by_gap); }},
      .naive = {"the eight-point solution, without a check",
                [] { return measure_error(eight_points_do); }},
      .mutants = {{"only the rank is checked", [] { return measure_error(by_rank); }},
                  {"only planes are reported as degenerate",
                   [] { return measure_error(by_homography); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
