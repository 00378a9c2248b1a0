#include "labs/10-epipolar/reference.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <glassbox/base/rounding.h>

#include "views/two_view/linear_fit.h"

namespace glassbox::labs::epipolar {

using views::Matrix3d;
using views::Vector3d;

namespace {

constexpr double u = unit_roundoff<double>;

Matrix3d calibration_of(const lab_10::Camera& camera) {
  Matrix3d k;
  k << camera.f, 0, camera.x, 0, camera.f, camera.y, 0, 0, 1;
  return k;
}

Vector3d ray_direction(const lab_10::Camera& camera, const lab_10::Pixel& pixel) {
  return {(pixel.x - camera.x) / camera.f, (pixel.y - camera.y) / camera.f, 1};
}

}  // namespace

Matrix3d matrix_of(const lab_10::Matrix& m) {
  Matrix3d made;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      made(row, column) = m[std::size_t(row)][std::size_t(column)];
  }
  return made;
}

Vector3d vector_of(const lab_10::Vector& v) {
  return {v[0], v[1], v[2]};
}

views::RelativePose pose_of(const lab_10::Pose& pose) {
  return {matrix_of(pose.rotation), vector_of(pose.translation)};
}

views::Matches matches_of(const std::vector<lab_10::Match>& matches) {
  views::Matches made;
  for (const lab_10::Match& m : matches)
    made.push_back({{m.left.x, m.left.y}, {m.right.x, m.right.y}});
  return made;
}

std::vector<double> entries_of(const Matrix3d& m) {
  std::vector<double> entries;
  for (int i = 0; i < 9; ++i) entries.push_back(m(i / 3, i % 3));
  return entries;
}

Matrix3d told(const Matrix3d& m) {
  double largest = 0;
  for (const double x : entries_of(m)) {
    if (std::abs(x) > std::abs(largest)) largest = x;
  }
  return m / (largest < 0 ? -m.norm() : m.norm());
}

// The bound of the solution. Rounding changes the linear system by some 20 u of its largest
// singular value sigma_1, in the student's solver and in ours (u = 2^-53 is the unit roundoff).
// That turns the solution by this change divided by the gap between the last two singular values.
// Undoing the normalisation multiplies the error by |T_r| |T_l|, the sizes of the normalising
// matrices, relative to the size of the resulting matrix. Taking the nearest essential matrix
// multiplies it by at most four if the matrix is almost essential; scaling to length 1 doubles it.
LinearSolution solve(const views::Matches& calibrated) {
  const auto normal = views::normalised(calibrated);
  if (!normal) return {};
  const auto fit = views::linear_fit(normal->matches);
  if (!fit) return {};
  const auto carried_back = [&](const Matrix3d& m) {
    return Matrix3d(normal->right.transpose() * m * normal->left);
  };
  const Matrix3d carried = carried_back(fit->matrix);
  LinearSolution solution;
  solution.essential = told(views::nearest_essential(carried));
  solution.not_carried_back = told(views::nearest_essential(fit->matrix));
  solution.made_rank_two_first = told(carried_back(views::nearest_essential(fit->matrix)));
  const auto& sigma = fit->singular_values;
  solution.condition = sigma[0] / (sigma[7] - sigma[8]);
  const double larger = std::max(1.0, normal->right.norm() * normal->left.norm() / carried.norm());
  solution.bound = 20 * u * solution.condition * larger * 4 * 2;
  return solution;
}

// The bound of a line (a, b, c). The vector v = E p has a rounding error of 5 u |E| |p|, where u is
// the unit roundoff and p the calibrated point. c is a sum of three products of v with f, x and y
// of the right camera, which multiply that error. Then everything is divided by |(v_x, v_y)|, whose
// own relative error is multiplied by |c|: beside the epipole |c| is large.
double bound_of_line(const lab_10::Matrix& essential, const lab_10::Camera& left,
                     const lab_10::Camera& right, const lab_10::Pixel& pixel) {
  const Matrix3d e = matrix_of(essential);
  const Vector3d seen = ray_direction(left, pixel), line = e * seen;
  const double size = line.head<2>().norm();
  if (size == 0) return 0;
  const double c = std::abs(line_of(essential, left, right, pixel).c);
  const double largest = std::max({right.f, std::abs(right.x), std::abs(right.y)});
  return 64 * u * (1 + c + largest) * e.norm() * seen.norm() / size;
}

lab_10::Line line_of(const lab_10::Matrix& essential, const lab_10::Camera& left,
                     const lab_10::Camera& right, const lab_10::Pixel& pixel) {
  const Vector3d seen = matrix_of(essential) * ray_direction(left, pixel);
  Vector3d line = calibration_of(right).inverse().transpose() * seen;
  const double size = line.head<2>().norm();
  if (size == 0) return {};
  line /= line.y() < 0 || (line.y() == 0 && line.x() < 0) ? -size : size;
  return {line.x(), line.y(), line.z()};
}

views::Triangulated point_of(const views::Rays& rays, const views::RelativePose& pose) {
  return views::midpoint(rays, pose);
}

// The bound of a point. For the directions d and e of the lines of sight, how far the point is
// along each line is a sum of products divided by |d x e|^2. In the sum, large terms may cancel to
// the square of the sine of the angle between the lines, so their rounding errors grow by one over
// this square.
double bound_of_point(const views::Rays& rays, const views::RelativePose& pose,
                      const views::Triangulated& point) {
  if (!point.is_finite()) return 0;
  const Vector3d d = rays.left.normalized();
  const Vector3d e = (pose.rotation.transpose() * rays.right).normalized();
  const double size = point.point.head<3>().norm() + pose.translation.norm();
  return 64 * u * size / d.cross(e).squaredNorm();
}

}  // namespace glassbox::labs::epipolar
