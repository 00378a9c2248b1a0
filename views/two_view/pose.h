// From an essential matrix to where the cameras stood.
#pragma once

#include <array>
#include <optional>

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::views {

// The four (R, T) with E = R S up to sign and scale: T or -T, and the right camera turned half round the baseline or not (C-105).
// T is of length 1: pictures do not tell how far apart cameras are.
std::array<RelativePose, 4> poses_of(const Matrix3d& essential);

// How many calibrated matches lie in front of both cameras.
int in_front_of_both(const RelativePose& pose, const Matches& calibrated);

// The one of the four for which more matches lie in front of both cameras than for any other.
struct ChosenPose {
  RelativePose pose;
  int in_front = 0;  // of the matches
  int runner_up = 0;
};
std::optional<ChosenPose> pose_in_front(const Matrix3d& essential, const Matches& calibrated);

// The angle between the direction that was estimated and what it is, radians.
double direction_error(const Vector3d& estimated, const Vector3d& truth);

}  // namespace glassbox::views
