#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c101 {

using Decision = views::PairKind (*)(const views::PairClassification&);

views::PairKind by_criterion(const views::PairClassification& judged) {
  return judged.kind;
}
// A fundamental matrix has more degrees of freedom than a rotation, so it always fits better, and
// this code never reports a rotation.
views::PairKind by_fit_alone(const views::PairClassification& judged) {
  const double freedom = 0.5 * judged.cost_of_fundamental;
  return judged.cost_of_rotation < judged.cost_of_fundamental - freedom
             ? views::PairKind::kPureRotation
             : views::PairKind::kGeneral;
}

Outcome measure_error(Decision decision) {
  Random random(101);
  constexpr double kSigma = 0.5;
  int wrong = 0, tried = 0;
  const auto ask = [&](const views::StereoRig& rig, const views::Matches& pixels,
                       views::PairKind right) {
    const auto judged =
        views::classify_pair(pixels, rig.left_intrinsic, rig.right_intrinsic, kSigma);
    wrong += !judged || decision(*judged) != right;
    ++tried;
  };
  for (int i = 0; i < 20; ++i) {
    views::StereoRig rig = random_rig(random);
    ask(rig, matches_of(random, rig, 60, kSigma), views::PairKind::kGeneral);
    rig.pose.translation.setZero();
    ask(rig, matches_of(random, rig, 60, kSigma), views::PairKind::kPureRotation);
  }
  return wrong_count_outcome(wrong, tried, "pairs of cameras are reported wrongly");
}

}  // namespace c101

ExtremeCase c101_pure_rotation() {
  using namespace c101;
  return {
      .id = "C-101",
      .name = "A camera that only turns",
      .construction =
          "20 pairs of cameras that moved and turned, 20 that only turned; 60 matches with a noise "
          "of 1/2 "
          "px",
      .stage = "two views",
      .right_answer =
          "a camera that only turns is reported as such, because E is 0 and any direction of T "
          "fits; the decision compares residuals plus a cost for each model's number of parameters "
          "(Torr 2002)",
      .unit = "pairs",
      .oracle = Oracle::kProperty,
      .ours = {"the costs of three models are compared",
               [] { return measure_error(by_criterion); }},
      .naive = {"the eight-point solution, without a check",
                [] { return measure_error(naive::always_general); }},
      .mutants = {{"the cost does not count a model's parameters",
                   [] { return measure_error(by_fit_alone); }},
                  {"every homography is reported as a plane",
                   [] { return measure_error(naive::turned_is_a_plane); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
