#include "labs/10-epipolar/reference.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <glassbox/base/rounding.h>

#include "views/two_view/linear_fit.h"

namespace glassbox::labs::epipolar {

using views::Matrix3d;
using views::Vector3d;

namespace {

constexpr double u = unit_roundoff<double>;

}  // namespace

Wide wide(const lab_10::Matrix& m) {
  return matrix_of(m).cast<long double>();
}
WideVector wide(const lab_10::Vector& v) {
  return vector_of(v).cast<long double>();
}

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

// The bounds of a line (a, b, c). A coordinate of p has a relative error of 2 u, so v = E p has one
// of 5 u |E| |p| (p is the calibrated point). Divided by |(v_x, v_y)|, that is the error of the
// line's direction; the root and the quotient round by another 4 u, and |(v_x, v_y)| is at most |E|
// |p|. c is a sum of three products of v with f, x and y of the right camera, which multiply the
// error of v, and round by 3 u each. The error of |(v_x, v_y)| is multiplied by |c|, which is large
// where the line is far from the principal point. 64 u is allowed for each.
ExactLine exact_line_of(const lab_10::Matrix& essential, const lab_10::Camera& left,
                        const lab_10::Camera& right, const lab_10::Pixel& pixel) {
  const WideVector seen{(static_cast<long double>(pixel.x) - left.x) / left.f,
                        (static_cast<long double>(pixel.y) - left.y) / left.f, 1};
  const Wide e = wide(essential);
  const WideVector v = e * seen;
  ExactLine exact;
  exact.across = v.head<2>().norm();
  exact.size = e.norm() * seen.norm();
  if (exact.across == 0) return exact;
  const long double factor = (v.y() < 0 || (v.y() == 0 && v.x() < 0) ? -1 : 1) / exact.across;
  exact.line = {double(factor * v.x()), double(factor * v.y()),
                double(factor * (right.f * v.z() - right.x * v.x() - right.y * v.y()))};
  const double largest = std::max({right.f, std::abs(right.x), std::abs(right.y)});
  exact.bound_of_ab = double(64 * u * exact.size / exact.across);
  exact.bound_of_c = exact.bound_of_ab * (1 + std::abs(exact.line.c) + largest);
  return exact;
}

// The limits of the angle. e = R^T p has an error of at most 5.2 u |e|, as each of its coordinates
// rounds by at most 3 u |e|; d x e rounds by at most 2.9 u |d| |e|, and the lengths by less than 1
// u of the product: together less than 9.1 u. So a sine of at most 4 u is computed as one below
// 13.1 u, and one of at least 32 u as one above 22.9 u: only between them can rounding decide on
// which side of 16 u the sine is.
//
// The bound of the point. How far it is along each line is a sum of products divided by |d x e|^2.
// If that is computed as |d|^2 |e|^2 - (d . e)^2, terms cancel to the square of the sine, so their
// rounding errors grow by one over this square.
ExactPoint exact_point_of(const lab_10::Pixel& left, const lab_10::Pixel& right,
                          const lab_10::Pose& pose) {
  const WideVector d{left.x, left.y, 1}, t = wide(pose.translation);
  const WideVector e = wide(pose.rotation).transpose() * WideVector{right.x, right.y, 1};
  const WideVector across = d.cross(e);
  ExactPoint exact;
  exact.sine = across.norm() / (d.norm() * e.norm());
  if (exact.sine <= 16 * u) {
    exact.place = {left.x, left.y, 1};
    exact.w = 0;
    return exact;
  }
  const long double squared = across.squaredNorm();
  const WideVector on_left = t.cross(e).dot(across) / squared * d;
  const WideVector on_right = t + t.cross(d).dot(across) / squared * e;
  const WideVector p = (on_left + on_right) / 2;
  exact.place = {double(p[0]), double(p[1]), double(p[2])};
  exact.gap = double((on_left - on_right).norm());
  exact.bound = double(64 * u * (p.norm() + t.norm()) / (exact.sine * exact.sine));
  return exact;
}

bool is_between(const ExactPoint& exact) {
  return exact.sine > 4 * u && exact.sine < 32 * u;
}

}  // namespace glassbox::labs::epipolar
