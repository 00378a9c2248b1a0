#include "views/two_view/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace glassbox::views {

namespace {

// Newton's method, as long as it brings the value nearer to 0.
double improved(const Eigen::VectorXd& coefficients, double x) {
  constexpr int kMaxSteps = 20;
  const Eigen::Index degree = coefficients.size() - 1;
  Eigen::VectorXd slope(degree);
  for (Eigen::Index i = 0; i < degree; ++i) slope[i] = double(i + 1) * coefficients[i + 1];
  double value = polynomial_at(coefficients, x);
  for (int step = 0; step < kMaxSteps && value != 0; ++step) {
    const double next = x - value / polynomial_at(slope, x);
    const double next_value = polynomial_at(coefficients, next);
    if (!(std::abs(next_value) < std::abs(value))) break;
    x = next;
    value = next_value;
  }
  return x;
}

}  // namespace

double polynomial_at(const Eigen::VectorXd& coefficients, double x) {
  double value = 0;
  for (Eigen::Index i = coefficients.size(); i-- > 0;) value = value * x + coefficients[i];
  return value;
}

std::vector<double> real_roots(const Eigen::VectorXd& coefficients) {
  constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;
  // A leading coefficient below the rounding error of the largest coefficient has no meaning.
  const double least = kUnitRoundoff * coefficients.cwiseAbs().maxCoeff();
  Eigen::Index degree = coefficients.size() - 1;
  while (degree > 0 && std::abs(coefficients[degree]) <= least) --degree;
  if (degree <= 0) return {};
  const Eigen::VectorXd used = coefficients.head(degree + 1);
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  companion.diagonal(-1).setOnes();
  companion.col(degree - 1) = -used.head(degree) / used[degree];
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion, false);
  // An eigenvalue for a root of multiplicity m has an error of the m-th root of the unit roundoff.
  // This tolerance, for m = 2, makes sure that double roots are not lost.
  const double close = 8 * std::sqrt(kUnitRoundoff);
  std::vector<double> roots;
  for (const std::complex<double>& value : solver.eigenvalues()) {
    if (std::abs(value.imag()) > close * (1 + std::abs(value))) continue;
    roots.push_back(improved(used, value.real()));
  }
  std::ranges::sort(roots);
  return roots;
}

}  // namespace glassbox::views
