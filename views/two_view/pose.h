// The relative pose of the cameras from an essential matrix.
#pragma once

#include <array>
#include <optional>

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::views {

// The four poses (R, T) for which R S, with S v = T x v, is E up to sign and scale: with T or -T,
// and with the right camera turned by half a turn about the baseline or not (C-105). T has length
// 1, because pictures do not show how far apart the cameras are.
std::array<RelativePose, 4> poses_of(const Matrix3d& essential);

// The number of calibrated matches in front of both cameras.
int in_front_of_both(const RelativePose& pose, const Matches& calibrated);

// The one of the four possible poses that has the most matches in front of both cameras. None if
// two poses have equally many.
struct ChosenPose {
  RelativePose pose;
  int in_front = 0;   // number of matches in front of both cameras
  int runner_up = 0;  // the same number for the second best pose
};
std::optional<ChosenPose> pose_in_front(const Matrix3d& essential, const Matches& calibrated);

// The angle between the estimated direction and the true one, radians.
double direction_error(const Vector3d& estimated, const Vector3d& truth);

}  // namespace glassbox::views
