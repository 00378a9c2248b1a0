#include <glassbox/base/rounding.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c100 {

using Solver = views::Matrix3d (*)(const views::Matches& pixels);

views::Matrix3d by_singular_values(const views::Matches& pixels) {
  return views::fit_fundamental(pixels, views::Conditioning::kNormalised)->matrix;
}
template <class T>
views::Matrix3d normalised_by_normal_equations(const views::Matches& pixels) {
  const auto normal = views::normalised(pixels);
  const views::Matrix3d m = naive::matrix_by_normal_equations<T>(normal->matches);
  return normal->right.transpose() * m * normal->left;
}

// The matches have no noise, so every error comes from rounding. Compares essential matrices and
// not fundamental ones, whose entries have very different sizes.
Outcome measure_error(Solver solver) {
  Random random(100);
  WorstError worst;
  for (int i = 0; i < 60; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matches pixels = matches_of(random, rig, 20, 0);
    const auto as_essential = [&](const views::Matrix3d& f) {
      return views::Matrix3d(rig.right_intrinsic.transpose() * f * rig.left_intrinsic);
    };
    const double error =
        matrix_distance(as_essential(solver(pixels)), as_essential(views::fundamental_of(rig)));
    const auto fit = views::fit_fundamental(pixels, views::Conditioning::kNormalised);
    const double condition = fit->system.condition();
    worst.add(error, 64 * unit_roundoff<double> * condition, fmt::format("pair {}", i), condition);
  }
  return worst.outcome();
}

}  // namespace c100

ExtremeCase c100_normal_equations() {
  using namespace c100;
  return {
      .id = "C-100",
      .name = "Eight points by normal equations",
      .construction = "60 pairs of cameras, 20 matches without noise, in pixels",
      .stage = "two views",
      .right_answer =
          "the error is at most 64 u times the condition number of the normalised system; the "
          "condition number of A^T A is the square of that of A, about 10^10 for raw pixels, but a "
          "float has only 7 digits",
      .unit = "of |E|",
      .oracle = Oracle::kAnalytic,
      .ours = {"singular values of normalised points",
               [] { return measure_error(by_singular_values); }},
      .naive = {"normal equations of pixels in float",
                [] { return measure_error(naive::matrix_by_normal_equations<float>); }},
      .mutants = {{"normal equations of normalised points in float",
                   [] { return measure_error(normalised_by_normal_equations<float>); }},
                  {"normal equations of pixels in double",
                   [] { return measure_error(naive::matrix_by_normal_equations<double>); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
