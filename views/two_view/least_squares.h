// Least squares by Levenberg and Marquardt's method, with Eigen's implementation.
#pragma once

#include <functional>

#include <Eigen/Core>

namespace glassbox::views {

// residuals(at, off) writes the residuals for the unknowns `at` into `off`, which has the right
// size.
using Residuals = std::function<void(const Eigen::VectorXd& at, Eigen::VectorXd& off)>;

// The unknowns that minimise the sum of the squares of `count` residuals. The search begins with
// all unknowns at 0 and ends in the first local minimum that it reaches. All stay 0 if there are
// fewer residuals than unknowns.
Eigen::VectorXd least_squares(int unknowns, int count, const Residuals& residuals);

// The covariance of the unknowns at 0 if each residual has an error of variance 1: (J^T J)^-1,
// where J has the derivatives of the residuals. Infinite if they do not determine all unknowns.
Eigen::MatrixXd covariance_at_zero(int unknowns, int count, const Residuals& residuals);

}  // namespace glassbox::views
