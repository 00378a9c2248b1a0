// The geometry of two views (views/two_view) in lab 10's terms, with what its answers may differ by.
#pragma once

#include <optional>
#include <vector>

#include "labs/10-epipolar/student.h"
#include "views/two_view/match.h"
#include "views/two_view/triangulation.h"

namespace glassbox::labs::epipolar {

views::Matrix3d matrix_of(const lab_10::Matrix& m);
views::Vector3d vector_of(const lab_10::Vector& v);
views::RelativePose pose_of(const lab_10::Pose& pose);
views::Matches matches_of(const std::vector<lab_10::Match>& matches);
// Row by row.
std::vector<double> entries_of(const views::Matrix3d& m);

// Scaled to |M| = 1, the entry that is largest in size positive: what told() of student.h makes of it.
views::Matrix3d told(const views::Matrix3d& m);

// What eight_point() gives, told, and what comes of it with a step too few or in the wrong place.
struct LinearSolution {
  views::Matrix3d essential;
  views::Matrix3d not_carried_back;  // the nearest essential matrix of the normalised points' one
  views::Matrix3d made_rank_two_first;  // that one, carried back
  double condition = 0;                 // sigma_1/(sigma_8 - sigma_9) of the normalised system
  double bound = 0;                     // of an entry of either
};
LinearSolution solve(const views::Matches& calibrated);

// What line, pose and point may differ by (student.h).
double bound_of_line(const lab_10::Matrix& essential, const lab_10::Camera& left,
                     const lab_10::Camera& right, const lab_10::Pixel& pixel);
lab_10::Line line_of(const lab_10::Matrix& essential, const lab_10::Camera& left,
                     const lab_10::Camera& right, const lab_10::Pixel& pixel);
inline constexpr double kPoseBound = 256 * 0x1p-53;
views::Triangulated point_of(const views::Rays& rays, const views::RelativePose& pose);
double bound_of_point(const views::Rays& rays, const views::RelativePose& pose,
                      const views::Triangulated& point);

}  // namespace glassbox::labs::epipolar
