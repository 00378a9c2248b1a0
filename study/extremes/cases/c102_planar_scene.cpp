#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"
#include "views/two_view/constraint.h"
#include "views/two_view/minimal_solvers.h"

namespace glassbox::study {
namespace c102 {

// Computes the rank of the system of eight-point equations, and candidates for the essential
// matrix.
struct Subject102 {
  int (*rank)(const views::Matches& calibrated);
  std::vector<views::Matrix3d> (*essentials)(const views::Matches& calibrated);
};

int by_singular_values(const views::Matches& matches) {
  return views::linear_fit(views::normalised(matches)->matches)->rank();
}
int count_equations(const views::Matches& matches) {
  return std::min(int(matches.size()), 8);
}
int count_nonzero_values(const views::Matches& matches) {
  const auto fit = views::linear_fit(views::normalised(matches)->matches);
  return int((fit->singular_values.array() != 0).count());
}
std::vector<views::Matrix3d> five_points(const views::Matches& matches) {
  const views::Matches sample(matches.begin(), matches.begin() + 5);
  const auto found = views::five_point(sample);
  return found ? *found : std::vector<views::Matrix3d>();
}
std::vector<views::Matrix3d> eight_points(const views::Matches& matches) {
  return {views::fit_essential(matches, views::Conditioning::kNormalised)->matrix};
}

Outcome measure_error(auto rank_by, auto essentials_by) {
  const Subject102 subject{rank_by, essentials_by};
  Random random(102);
  int wrong = 0, tried = 0;
  for (int i = 0; i < 30; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matrix3d right = views::essential<double>(rig.pose.rotation, rig.pose.translation);
    for (const bool flat : {true, false}) {
      const views::Matches pixels =
          flat ? matches_of_plane(random, rig, 20, 0) : matches_of(random, rig, 20, 0);
      const views::Matches matches = calibrated(pixels, rig);
      wrong += subject.rank(matches) != (flat ? 6 : 8);
      double nearest = 1;
      for (const views::Matrix3d& e : subject.essentials(matches))
        nearest = std::min(nearest, matrix_distance(e, right));
      wrong += nearest > 1e-6;
      tried += 2;
    }
  }
  return wrong_count_outcome(wrong, tried, "answers are wrong");
}

}  // namespace c102

ExtremeCase c102_planar_scene() {
  using namespace c102;
  return {
      .id = "C-102",
      .name = "All points on a plane",
      .construction =
          "30 pairs of cameras, 20 matches without noise, of points on a plane and of points in "
          "any position",
      .stage = "two views",
      .right_answer =
          "the rank of the system is 6, and 8 for points in any position; the solutions for five "
          "calibrated points contain the right E in both cases, to 1e-6 (roots of degree 10 lose "
          "half of the digits)",
      .unit = "answers",
      .oracle = Oracle::kAnalytic,
      .ours = {"the rank from singular values, and the five-point solution",
               [] { return measure_error(by_singular_values, five_points); }},
      .naive = {"the rank is taken to be the number of matches, and the eight-point solution",
                [] { return measure_error(count_equations, eight_points); }},
      .mutants = {{"only singular values of exactly 0 count as 0",
                   [] { return measure_error(count_nonzero_values, five_points); }},
                  {"the eight-point solution instead of the five-point one",
                   [] { return measure_error(by_singular_values, eight_points); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
