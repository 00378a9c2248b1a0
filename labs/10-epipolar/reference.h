// The geometry of two views (views/two_view) with the types of lab 10, and the bounds for its
// answers.
#pragma once

#include <vector>

#include "labs/10-epipolar/student.h"
#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::labs::epipolar {

views::Matrix3d matrix_of(const lab_10::Matrix& m);
views::Vector3d vector_of(const lab_10::Vector& v);
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

// The error bound that student.h states for a pose.
inline constexpr double kPoseBound = 256 * 0x1p-53;

// A matrix in extended precision: expected answers are computed in it and then rounded once.
using Wide = Eigen::Matrix<long double, 3, 3>;
using WideVector = Eigen::Matrix<long double, 3, 1>;
Wide wide(const lab_10::Matrix& m);
WideVector wide(const lab_10::Vector& v);

// The epipolar line of a pixel, and the error bounds that student.h states for it.
struct ExactLine {
  lab_10::Line line;
  double bound_of_ab = 0, bound_of_c = 0;
  long double across = 0, size = 0;  // |(v_x, v_y)| and |E| |p_l|
};
ExactLine exact_line_of(const lab_10::Matrix& essential, const lab_10::Camera& left,
                        const lab_10::Camera& right, const lab_10::Pixel& pixel);

// The point where two lines of sight meet, and the error bound that student.h states for its place;
// its w is exact.
struct ExactPoint {
  lab_10::Vector place{};
  double w = 1, bound = 0;
  long double sine = 0;  // of the angle between the lines: |d x e| / (|d| |e|)
  double gap = 0;        // the lines pass each other at this distance
};
ExactPoint exact_point_of(const lab_10::Pixel& left, const lab_10::Pixel& right,
                          const lab_10::Pose& pose);
// Whether rounding decides if the lines are parallel.
bool is_between(const ExactPoint& exact);

}  // namespace glassbox::labs::epipolar
