#include "views/two_view/minimal_solvers.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include <glassbox/base/trig.h>

#include "views/two_view/linear_fit.h"
#include "views/two_view/polynomial.h"

namespace glassbox::views {

namespace {

using Eigen::Matrix3d;

// The coefficients of det(t A + B) = c3 t^3 + c2 t^2 + c1 t + c0, from the values of the polynomial
// at 0, 1, -1 and infinity (the leading coefficient).
Eigen::VectorXd determinant_of_pencil(const Matrix3d& a, const Matrix3d& b) {
  const double c0 = b.determinant(), c3 = a.determinant();
  const double at_one = (a + b).determinant(), at_minus_one = (b - a).determinant();
  Eigen::VectorXd c(4);
  c << c0, (at_one - at_minus_one) / 2 - c3, (at_one + at_minus_one) / 2 - c0, c3;
  return c;
}

}  // namespace

Result<std::vector<Matrix3d>> seven_point(const Matches& pixels) {
  const auto from = normalised(pixels);
  if (!from) return tl::unexpected(from.error());
  const auto fit = linear_fit(from->matches, 7);
  if (!fit) return tl::unexpected(fit.error());
  if (fit->rank() < 7) {
    return fail(
        "the matches",
        "they give fewer than the seven independent equations that the 7-point method needs",
        "give matches whose points are not all in one plane or on one line");
  }
  const auto kernel = fit->kernel.rightCols(2);
  // A root at infinity would be lost, so several bases of the same pencil are tried. The basis is
  // taken whose first matrix is farthest from singular, as its determinant is the leading
  // coefficient.
  Eigen::VectorXd best = Eigen::VectorXd::Zero(4);
  Matrix3d first = Matrix3d::Zero(), second = Matrix3d::Zero();
  constexpr int kBases = 4;
  for (int i = 0; i < kBases; ++i) {
    const double angle = i * std::numbers::pi / kBases;
    const auto [s, c] = sin_cos(angle);
    const Matrix3d a = (c * kernel.col(0) + s * kernel.col(1)).reshaped<Eigen::RowMajor>(3, 3);
    const Matrix3d b = (-s * kernel.col(0) + c * kernel.col(1)).reshaped<Eigen::RowMajor>(3, 3);
    const Eigen::VectorXd determinant = determinant_of_pencil(a, b);
    if (std::abs(determinant[3]) <= std::abs(best[3])) continue;
    best = determinant;
    first = a;
    second = b;
  }
  std::vector<Matrix3d> found;
  for (const double t : real_roots(best)) {
    found.push_back(from->right.transpose() * (t * first + second) * from->left);
  }
  return found;
}

}  // namespace glassbox::views
