#include "views/two_view/minimal_solvers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <glassbox/base/elementary.h>

#include "views/two_view/constraint.h"
#include "views/two_view/linear_fit.h"

namespace glassbox::views {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Basis = std::array<Matrix3d, 4>;  // a basis X, Y, Z, W of the possible matrices
using Cubics = Eigen::MatrixXd;         // 10 x 20: coefficients of the ten equations

// ---- polynomials of degree 3 or less in x, y and z ----

constexpr int kMonomials = 20;
// Exponents of x, y, z: the ten cubic monomials, then the ten smaller ones, by descending degree.
constexpr std::array<std::array<int, 3>, kMonomials> kPowers{
    {{3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1}, {1, 0, 2}, {0, 3, 0},
     {0, 2, 1}, {0, 1, 2}, {0, 0, 3}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0},
     {0, 1, 1}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
constexpr int kX = 16, kY = 17, kZ = 18, kOne = 19, kFirstSmall = 10;

int index_of(const std::array<int, 3>& powers) {
  return int(std::ranges::find(kPowers, powers) - kPowers.begin());
}

struct Polynomial {
  Eigen::Matrix<double, 1, kMonomials> c = Eigen::Matrix<double, 1, kMonomials>::Zero();

  Polynomial& operator+=(const Polynomial& other) {
    c += other.c;
    return *this;
  }
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) {
    a.c -= b.c;
    return a;
  }
  // The degrees of the factors must add up to at most 3.
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product;
    for (int i = 0; i < kMonomials; ++i) {
      if (a.c[i] == 0) continue;
      for (int j = 0; j < kMonomials; ++j) {
        if (b.c[j] == 0) continue;
        const auto& p = kPowers[std::size_t(i)];
        const auto& q = kPowers[std::size_t(j)];
        product.c[index_of({p[0] + q[0], p[1] + q[1], p[2] + q[2]})] += a.c[i] * b.c[j];
      }
    }
    return product;
  }
};

using PolynomialMatrix = std::array<std::array<Polynomial, 3>, 3>;

PolynomialMatrix unknown_essential(const Basis& basis) {
  PolynomialMatrix e;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      auto& c = e[std::size_t(row)][std::size_t(column)].c;
      c[kX] = basis[0](row, column);
      c[kY] = basis[1](row, column);
      c[kZ] = basis[2](row, column);
      c[kOne] = basis[3](row, column);
    }
  }
  return e;
}

Polynomial determinant(const PolynomialMatrix& e) {
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
         e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

// The ten cubic equations for E = x X + y Y + z Z + W: det E = 0, and the nine entries of 2 E E^T E
// - tr(E E^T) E = 0.
Cubics cubics_of(const Basis& basis) {
  const PolynomialMatrix e = unknown_essential(basis);
  PolynomialMatrix square;
  Polynomial trace;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) square[i][j] += e[i][k] * e[j][k];
    }
    trace += square[i][i];
  }
  Cubics rows(10, kMonomials);
  rows.row(0) = determinant(e).c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Polynomial sum;
      for (std::size_t k = 0; k < 3; ++k) sum += square[i][k] * e[k][j];
      rows.row(Eigen::Index(1 + 3 * i + j)) = 2 * sum.c - (trace * e[i][j]).c;
    }
  }
  return rows;
}

// ---- the common roots of the cubic equations ----

Matrix3d combined(const Basis& basis, const Vector3d& at) {
  return at.x() * basis[0] + at.y() * basis[1] + at.z() * basis[2] + basis[3];
}

Eigen::VectorXd monomials_at(const Vector3d& at) {
  Eigen::VectorXd values(kMonomials);
  for (int i = 0; i < kMonomials; ++i) {
    const auto& [p, q, r] = kPowers[std::size_t(i)];
    values[i] = whole_power(at.x(), p) * whole_power(at.y(), q) * whole_power(at.z(), r);
  }
  return values;
}

// The derivatives d/dx, d/dy, d/dz of each monomial.
Eigen::MatrixXd monomial_slopes_at(const Vector3d& at) {
  Eigen::MatrixXd slopes(kMonomials, 3);
  for (int i = 0; i < kMonomials; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<int, 3> powers = kPowers[std::size_t(i)];
      const int factor = powers[axis];
      powers[axis] = std::max(0, factor - 1);
      slopes(i, Eigen::Index(axis)) = factor * whole_power(at.x(), powers[0]) *
                                      whole_power(at.y(), powers[1]) *
                                      whole_power(at.z(), powers[2]);
    }
  }
  return slopes;
}

// Improves an approximate root by Gauss-Newton steps, as long as the residual of the equations
// decreases.
Vector3d improved(const Cubics& cubics, Vector3d at) {
  constexpr int kMaxSteps = 10;
  Eigen::VectorXd residual = cubics * monomials_at(at);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::MatrixXd slopes = cubics * monomial_slopes_at(at);
    const Vector3d next = at - slopes.colPivHouseholderQr().solve(residual);
    const Eigen::VectorXd next_residual = cubics * monomials_at(next);
    if (!(next_residual.norm() < residual.norm())) break;
    at = next;
    residual = next_residual;
  }
  return at;
}

// The matrix that multiplies by x, in the basis of the ten monomials of degree 2 or less. x times a
// monomial of degree 2 is a cubic monomial, which the equations express by the ten smaller ones. x
// times a monomial of degree 1 or 0 is one of the ten itself.
Eigen::MatrixXd multiplication_by_x(const Cubics& cubics) {
  const Eigen::MatrixXd smaller = -Eigen::MatrixXd(cubics.leftCols(10))
                                       .partialPivLu()
                                       .solve(Eigen::MatrixXd(cubics.rightCols(10)));
  Eigen::MatrixXd action = Eigen::MatrixXd::Zero(10, 10);
  for (int i = 0; i < 10; ++i) {
    std::array<int, 3> powers = kPowers[std::size_t(kFirstSmall + i)];
    ++powers[0];
    const int product = index_of(powers);
    if (product < kFirstSmall) {
      action.row(i) = smaller.row(product);
    } else {
      action(i, product - kFirstSmall) = 1;
    }
  }
  return action;
}

// A matrix x X + y Y + z Z + W has no finite x, y, z if its component along W is 0. Points in
// special positions have such solutions in the basis that the decomposition returns; in a rotated
// basis this happens only by chance. The rotation is an orthogonal matrix without a zero entry.
Basis turned_basis(const Eigen::Matrix<double, 9, Eigen::Dynamic>& kernel) {
  Eigen::MatrixXd mixed(4, 4);
  mixed << 0.8, 0.4, -0.4, 0.2,  //
      -0.4, 0.8, -0.2, -0.4,     //
      0.4, -0.2, 0.2, -0.8588,   //
      0.2, 0.4, 0.8588, 0.25;
  const Eigen::MatrixXd turn = mixed.householderQr().householderQ();
  Basis basis;
  for (int k = 0; k < 4; ++k) {
    basis[std::size_t(k)] = (kernel * turn.col(k)).reshaped<Eigen::RowMajor>(3, 3);
  }
  return basis;
}

}  // namespace

Result<std::vector<Matrix3d>> five_point(const Matches& calibrated) {
  const auto fit = linear_fit(calibrated, 5);
  if (!fit) return tl::unexpected(fit.error());
  if (fit->rank() < 5) {
    return fail("the matches",
                "they give fewer than the five independent equations that the 5-point method needs",
                "give matches whose points are not all in one plane or on one line");
  }
  const Basis basis = turned_basis(fit->kernel.rightCols(4));
  const Cubics cubics = cubics_of(basis);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(multiplication_by_x(cubics));
  // Double roots are found with imaginary parts as large as the square root of the rounding error.
  const double close = 256 * std::sqrt(std::numeric_limits<double>::epsilon());
  std::vector<Matrix3d> found;
  for (int i = 0; i < 10; ++i) {
    const std::complex<double> x = solver.eigenvalues()[i];
    if (std::abs(x.imag()) > close * (1 + std::abs(x))) continue;
    const Eigen::VectorXd values = solver.eigenvectors().col(i).real();
    const Vector3d at = values.segment<3>(kX - kFirstSmall) / values[kOne - kFirstSmall];
    if (!at.allFinite()) continue;
    const Matrix3d e = combined(basis, improved(cubics, at)).normalized();
    const bool is_new = std::ranges::none_of(found, [&](const Matrix3d& other) {
      return std::min((e - other).norm(), (e + other).norm()) < close;
    });
    // If the Gauss-Newton steps did not reach a root, the matrix, whose norm is 1, does not have a
    // small residual 2 E E^T E - tr(E E^T) E.
    if (is_new && demazure<double>(e).norm() < close) found.push_back(e);
  }
  return found;
}

}  // namespace glassbox::views
