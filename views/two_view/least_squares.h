// Least squares by Levenberg and Marquardt's method, as Eigen has it.
#pragma once

#include <functional>

#include <Eigen/Core>

namespace glassbox::views {

// residuals(at, off) puts the residuals at the unknowns `at` into `off`, which has room for them.
using Residuals = std::function<void(const Eigen::VectorXd& at, Eigen::VectorXd& off)>;

// The unknowns for which the sum of the squares of `count` residuals is least. The search begins with
// all unknowns at 0 and ends in the minimum that it meets first. All stay 0 where there are fewer
// residuals than unknowns.
Eigen::VectorXd least_squares(int unknowns, int count, const Residuals& residuals);

}  // namespace glassbox::views
