// The geometry of two views (views/two_view) with the types of lab 10, and the bounds for its
// answers.
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
// The nine entries of the matrix, row by row.
std::vector<double> entries_of(const views::Matrix3d& m);

// The matrix scaled to |M| = 1, with the sign for which its entry of largest absolute value is
// positive, as told() of student.h does it.
views::Matrix3d told(const views::Matrix3d& m);

// The result of eight_point(), scaled by told(), and the wrong results that follow if one step is
// left out or done too early.
struct LinearSolution {
  views::Matrix3d essential;
  views::Matrix3d not_carried_back;     // wrong: the normalisation is not undone
  views::Matrix3d made_rank_two_first;  // wrong: rank 2 is made before the normalisation is undone
  double condition = 0;                 // sigma_1/(sigma_8 - sigma_9) of the normalised system
  double bound = 0;                     // the error bound of an entry of each matrix
};
LinearSolution solve(const views::Matches& calibrated);

// The reference answers of lab 10, and the error bounds that student.h states for the line, the
// pose and the point.
double bound_of_line(const lab_10::Matrix& essential, const lab_10::Camera& left,
                     const lab_10::Camera& right, const lab_10::Pixel& pixel);
lab_10::Line line_of(const lab_10::Matrix& essential, const lab_10::Camera& left,
                     const lab_10::Camera& right, const lab_10::Pixel& pixel);
inline constexpr double kPoseBound = 256 * 0x1p-53;
views::Triangulated point_of(const views::Rays& rays, const views::RelativePose& pose);
double bound_of_point(const views::Rays& rays, const views::RelativePose& pose,
                      const views::Triangulated& point);

}  // namespace glassbox::labs::epipolar
