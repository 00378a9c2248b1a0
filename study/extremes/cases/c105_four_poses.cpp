#include <glassbox/base/rounding.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"
#include "views/two_view/constraint.h"
#include "views/two_view/rotation.h"

namespace glassbox::study {
namespace c105 {

using Choice = views::RelativePose (*)(const views::Matrix3d& essential,
                                       const views::Matches& calibrated);

views::RelativePose in_front(const views::Matrix3d& essential, const views::Matches& calibrated) {
  const auto chosen = views::pose_in_front(essential, calibrated);
  return chosen ? chosen->pose : views::RelativePose{};
}

// The rotation and the direction of a pose are products of a few orthogonal matrices that are right
// to about 50 u each (u is the unit roundoff), so the bound is 512 u.
Outcome measure_error(Choice choice) {
  Random random(105);
  ErrorsAboveBound errors(512 * unit_roundoff<double>);
  for (int i = 0; i < 200; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matches matches = calibrated(matches_of(random, rig, 20, 0), rig);
    const double sign = random.unit() < 0.5 ? -1 : 1;
    const views::RelativePose found =
        choice(sign * views::essential<double>(rig.pose.rotation, rig.pose.translation), matches);
    errors.add(std::max(views::rotation_error(found.rotation, rig.pose.rotation),
                        views::direction_error(found.translation, rig.pose.translation)));
  }
  return errors.outcome("poses are wrong");
}

}  // namespace c105

ExtremeCase c105_four_poses() {
  using namespace c105;
  return {
      .id = "C-105",
      .name = "Four poses of one matrix",
      .construction = "E of 200 pairs of cameras, with either sign, and 20 matches of each",
      .stage = "two views",
      .right_answer =
          "exactly one of the four poses has all points in front of both cameras; it is right to "
          "512 u",
      .unit = "radian",
      .oracle = Oracle::kAnalytic,
      .ours = {"the pose with all points in front of both cameras",
               [] { return measure_error(in_front); }},
      .naive = {"the first of the four poses", [] { return measure_error(naive::first_of_four); }},
      .mutants = {{"only one rotation is tried, with both signs of T",
                   [] { return measure_error(naive::one_rotation); }},
                  {"the pose with all points in front of the left camera",
                   [] { return measure_error(naive::in_front_of_left); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
