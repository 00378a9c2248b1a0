#include "views/two_view/least_squares.h"

#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace glassbox::views {

namespace {

// The interface that Eigen's optimiser expects of a function: residuals depending on a few
// unknowns.
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

}  // namespace

Eigen::VectorXd least_squares(int unknowns, int count, const Residuals& residuals) {
  Eigen::VectorXd at = Eigen::VectorXd::Zero(unknowns);
  if (count < unknowns) return at;
  using Function = Eigen::NumericalDiff<ResidualFunction, Eigen::Central>;
  Function function(ResidualFunction{residuals, unknowns, count});
  Eigen::LevenbergMarquardt<Function> method(function);
  method.minimize(at);
  return at;
}

}  // namespace glassbox::views
