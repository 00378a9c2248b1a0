#include "views/two_view/linear_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace glassbox::views {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;

using Svd3 = Eigen::JacobiSVD<Matrix3d>;

Matrix3d with_singular_values(const Svd3& svd, const Eigen::Vector3d& values) {
  return svd.matrixU() * values.asDiagonal() * svd.matrixV().transpose();
}

Svd3 decomposed(const Matrix3d& matrix) {
  return Svd3(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

tl::unexpected<Error> not_finite() {
  return fail("the matches", "a coordinate is not finite, or too large for the computation",
              "leave the match with this coordinate out");
}

// Replaces Eigen's allFinite(), which subtracts each number from itself: for infinite ones that
// raises the floating-point exception "invalid operation".
template <class Matrix>
bool is_finite(const Matrix& matrix) {
  return matrix.array().isFinite().all();
}

// The normalising transform (see Normalised) for the points that `point` selects from each match.
template <class Pick>
Result<Matrix3d> normalising(const Matches& matches, const char* side, const Pick& point) {
  Vector2d centre = Vector2d::Zero();
  for (const Match& match : matches) {
    // This check comes first, because two infinite numbers must not be subtracted.
    if (!is_finite(point(match))) return not_finite();
    centre += point(match);
  }
  centre /= double(matches.size());
  double distance = 0;
  for (const Match& match : matches) distance += (point(match) - centre).norm();
  distance /= double(matches.size());
  if (!std::isfinite(distance)) return not_finite();  // a sum or a square has overflowed
  // All points count as equal if their mean distance from the centre is within its rounding error.
  const double rounding = double(matches.size()) * std::numeric_limits<double>::epsilon();
  if (!(distance > rounding * centre.norm())) {
    return fail("the matches", fmt::format("all points of the {} picture are the same", side),
                "give different points");
  }
  const double scale = std::sqrt(2.0) / distance;
  Matrix3d matrix;
  matrix << scale, 0, -scale * centre.x(), 0, scale, -scale * centre.y(), 0, 0, 1;
  return matrix;
}

Vector2d moved(const Matrix3d& similarity, const Vector2d& point) {
  return (similarity * point.homogeneous()).head<2>();
}

Matrix3d carried_back(const Matrix3d& matrix, const Normalised& from) {
  return from.right.transpose() * matrix * from.left;
}

}  // namespace

Eigen::Matrix<double, Eigen::Dynamic, 9> design_matrix(const Matches& matches) {
  Eigen::Matrix<double, Eigen::Dynamic, 9> rows(Eigen::Index(matches.size()), 9);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::RowVector3d left = matches[std::size_t(i)].left.homogeneous().transpose();
    const Eigen::Vector3d right = matches[std::size_t(i)].right.homogeneous();
    rows.row(i) << right[0] * left, right[1] * left, left;
  }
  return rows;
}

Result<Normalised> normalised(const Matches& matches) {
  const auto left = normalising(matches, "left", [](const Match& m) { return m.left; });
  if (!left) return tl::unexpected(left.error());
  const auto right = normalising(matches, "right", [](const Match& m) { return m.right; });
  if (!right) return tl::unexpected(right.error());
  Normalised result{matches, *left, *right};
  for (Match& match : result.matches) {
    match = {moved(*left, match.left), moved(*right, match.right)};
  }
  return result;
}

int LinearFit::rank() const {
  constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;
  const double least = 16 * kUnitRoundoff * singular_values[0];
  return int((singular_values.array() > least).count());
}

Result<LinearFit> linear_fit(const Matches& matches, int least) {
  if (int(matches.size()) < least) {
    return fail("the matches",
                fmt::format("there are {}, but {} are needed", matches.size(), least),
                "give more matches");
  }
  const auto rows = design_matrix(matches);
  if (!is_finite(rows)) return not_finite();
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner> svd(
      rows, Eigen::ComputeFullV);
  LinearFit fit;
  fit.singular_values.setZero();
  fit.singular_values.head(svd.singularValues().size()) = svd.singularValues();
  const Eigen::Matrix<double, 9, 9> directions = svd.matrixV();
  fit.kernel = directions.rightCols(9 - std::min(8, fit.rank()));
  fit.matrix = directions.col(8).reshaped<Eigen::RowMajor>(3, 3);
  return fit;
}

Result<EightPointFit> fit_fundamental(const Matches& pixels, Conditioning conditioning) {
  if (conditioning == Conditioning::kRaw) {
    return linear_fit(pixels).map([](const LinearFit& fit) {
      const Matrix3d matrix = with_rank_two(fit.matrix);
      return EightPointFit{matrix, fit};
    });
  }
  return normalised(pixels).and_then([](const Normalised& from) {
    return linear_fit(from.matches).map([&](const LinearFit& fit) {
      return EightPointFit{carried_back(with_rank_two(fit.matrix), from), fit};
    });
  });
}

Result<EightPointFit> fit_essential(const Matches& calibrated, Conditioning conditioning) {
  if (conditioning == Conditioning::kRaw) {
    return linear_fit(calibrated).map([](const LinearFit& fit) {
      return EightPointFit{nearest_essential(fit.matrix), fit};
    });
  }
  return normalised(calibrated).and_then([](const Normalised& from) {
    return linear_fit(from.matches).map([&](const LinearFit& fit) {
      return EightPointFit{nearest_essential(carried_back(fit.matrix, from)), fit};
    });
  });
}

Matrix3d with_rank_two(const Matrix3d& matrix) {
  const Svd3 svd = decomposed(matrix);
  return with_singular_values(svd, {svd.singularValues()[0], svd.singularValues()[1], 0});
}

Matrix3d nearest_essential(const Matrix3d& matrix) {
  const Svd3 svd = decomposed(matrix);
  const double mean = (svd.singularValues()[0] + svd.singularValues()[1]) / 2;
  return with_singular_values(svd, {mean, mean, 0});
}

}  // namespace glassbox::views
