#include <glassbox/base/rounding.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"
#include "views/two_view/constraint.h"

namespace glassbox::study {
namespace c106 {

using Estimator = views::Matrix3d (*)(const views::Matches& calibrated);

views::Matrix3d after(const views::Matches& calibrated) {
  const auto fit = views::fit_essential(calibrated, views::Conditioning::kNormalised);
  return fit ? fit->matrix : views::Matrix3d::Zero();
}

// Demazure's sum is zero for an essential matrix E. It has three products of three factors of norm
// 1, with 9 products for each entry: its rounding error is about 60 u (u is the unit roundoff),
// including the error of E itself.
Outcome measure_error(Estimator estimator) {
  Random random(106);
  ErrorsAboveBound errors(64 * unit_roundoff<double>);
  for (int i = 0; i < 60; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matches matches = calibrated(matches_of(random, rig, 20, 0.5), rig);
    errors.add(views::demazure<double>(estimator(matches).normalized()).norm());
  }
  return errors.outcome("matrices are not essential");
}

}  // namespace c106

ExtremeCase c106_rank_first() {
  using namespace c106;
  return {
      .id = "C-106",
      .name = "Rank before transforming back",
      .construction = "60 pairs of cameras, 20 calibrated matches with the noise of 1/2 px",
      .stage = "two views",
      .right_answer =
          "2 E E^T E = tr(E E^T) E for |E| = 1, to 64 u; this means two equal singular values and "
          "a 0, which change if the matrix is transformed afterwards",
      .unit = "of |E|^3",
      .oracle = Oracle::kAnalytic,
      .ours = {"E is transformed back first, then its singular values are made equal",
               [] { return measure_error(after); }},
      .naive = {"the singular values of E are made equal first, then E is transformed back",
                [] { return measure_error(naive::essential_made_before_carrying_back); }},
      .mutants = {{"only the third singular value is set to 0",
                   [] { return measure_error(naive::essential_of_rank_two); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
