#include "views/two_view/least_squares.h"

#include <limits>

#include <Eigen/LU>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace glassbox::views {

namespace {

// The interface that Eigen's optimiser expects of a function: residuals depending on a few
// unknowns. Here 1 is added to each unknown: the step of a numerical derivative is a fraction of
// the unknown, and for a tiny one it would be lost in the rounding errors of the residuals.
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
    residuals(at - Eigen::VectorXd::Ones(unknowns), off);
    return 0;
  }
};

using Differentiated = Eigen::NumericalDiff<ResidualFunction, Eigen::Central>;

}  // namespace

Eigen::VectorXd least_squares(int unknowns, int count, const Residuals& residuals) {
  Eigen::VectorXd at = Eigen::VectorXd::Ones(unknowns);
  if (count < unknowns) return at - Eigen::VectorXd::Ones(unknowns);
  Differentiated function(ResidualFunction{residuals, unknowns, count});
  Eigen::LevenbergMarquardt<Differentiated> method(function);
  method.parameters.xtol = 1e-12;  // relative to the unknowns, which are near 1 here
  method.minimize(at);
  return at - Eigen::VectorXd::Ones(unknowns);
}

Eigen::MatrixXd covariance_at_zero(int unknowns, int count, const Residuals& residuals) {
  const Differentiated function(ResidualFunction{residuals, unknowns, count});
  Eigen::MatrixXd slopes(count, unknowns);
  function.df(Eigen::VectorXd::Ones(unknowns), slopes);
  const Eigen::FullPivLU<Eigen::MatrixXd> information(slopes.transpose() * slopes);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return information.isInvertible() ? Eigen::MatrixXd(information.inverse())
                                    : Eigen::MatrixXd::Constant(unknowns, unknowns, kInfinity);
}

}  // namespace glassbox::views
