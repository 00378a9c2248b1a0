// Least squares by Levenberg and Marquardt's method, as Eigen has it.
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace glassbox::views {

// What Eigen's optimiser asks of a function: residuals as a function of a few numbers.
template <class Residuals>
struct ResidualFunction {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  static constexpr int InputsAtCompileTime = Eigen::Dynamic;
  static constexpr int ValuesAtCompileTime = Eigen::Dynamic;

  const Residuals& residuals;
  int unknowns, count;

  int inputs() const { return unknowns; }
  int values() const { return count; }
  int operator()(const Eigen::VectorXd& at, Eigen::VectorXd& off) const {
    residuals(at, off);
    return 0;
  }
};

// The unknowns, 0 at first, for which the squares of `count` residuals have the least sum near there. `residuals(at, off)` puts them
// into `off`, which has room for them. 0 where there are fewer residuals than unknowns.
template <class Residuals>
Eigen::VectorXd least_squares(int unknowns, int count, const Residuals& residuals) {
  Eigen::VectorXd at = Eigen::VectorXd::Zero(unknowns);
  if (count < unknowns) return at;
  using Function = Eigen::NumericalDiff<ResidualFunction<Residuals>, Eigen::Central>;
  Function function(ResidualFunction<Residuals>{residuals, unknowns, count});
  Eigen::LevenbergMarquardt<Function> method(function);
  method.minimize(at);
  return at;
}

}  // namespace glassbox::views
