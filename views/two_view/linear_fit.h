// The matrix of the constraint p_r^T M p_l = 0 from matches: a linear system in its nine entries (S2-12). M is F for pixels, E for
// calibrated points.
#pragma once

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// A row for each match: the products of the coordinates of (x_r, y_r, 1) and (x_l, y_l, 1), in the order of M's entries by rows.
Eigen::Matrix<double, Eigen::Dynamic, 9> design_matrix(const Matches& matches);

// Scaled and moved so that the centroid is 0 and the mean distance from it is the square root of 2 (Hartley, In Defense of the
// Eight-Point Algorithm, PAMI 19, 1997). An error if all points are one.
struct Normalised {
  Matches matches;
  Eigen::Matrix3d left, right;  // normalised = left * (x, y, 1)
};
Result<Normalised> normalised(const Matches& matches);

struct LinearFit {
  Eigen::Matrix3d matrix;  // not yet of rank 2; of Frobenius norm 1
  Eigen::Matrix<double, 9, 1>
      singular_values;  // of the system, descending; those that few matches lack are 0
  Eigen::Matrix<double, 9, Eigen::Dynamic>
      kernel;  // the directions without an equation, one column for each

  // Equations that are no combination of others, but for rounding: a row's entries are rounded once, so what is below 16 u of the
  // largest singular value is nothing.
  int rank() const;
  // Of the system in the eight unknowns that M has but for scale: the first over the eighth singular value.
  double condition() const { return singular_values[0] / singular_values[7]; }
};

// The least squares solution; an error for fewer than `least` matches, or numbers that are not finite.
Result<LinearFit> linear_fit(const Matches& matches, int least = 8);

// The eight-point algorithm: raw, or with normalised points and the result carried back. F is made of rank 2 where the system was
// solved, E (two equal singular values and 0) where its points are calibrated ones, which is after carrying back (C-106).
enum class Conditioning { kRaw, kNormalised };
struct EightPointFit {
  Eigen::Matrix3d matrix;
  LinearFit system;  // as it was solved
};
Result<EightPointFit> fit_fundamental(const Matches& pixels, Conditioning conditioning);
Result<EightPointFit> fit_essential(const Matches& calibrated, Conditioning conditioning);

// The nearest matrix of rank 2, and the nearest with singular values (s, s, 0), in the Frobenius norm.
Eigen::Matrix3d with_rank_two(const Eigen::Matrix3d& matrix);
Eigen::Matrix3d nearest_essential(const Eigen::Matrix3d& matrix);

}  // namespace glassbox::views
