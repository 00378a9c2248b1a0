// Roots of polynomials in one unknown.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace glassbox::views {

// The value c[0] + c[1] x + c[2] x^2 + ... of a polynomial, by Horner's rule.
double polynomial_at(const Eigen::VectorXd& coefficients, double x);

// The real roots in ascending order: the eigenvalues of the companion matrix whose imaginary part
// is within the error of a double root (a multiple of the square root of the unit roundoff), each
// improved by Newton's method. Leading zeros are ignored; a constant has no roots.
std::vector<double> real_roots(const Eigen::VectorXd& coefficients);

}  // namespace glassbox::views
