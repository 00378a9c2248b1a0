#include "views/two_view/pair_kind.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/base/elementary.h>

#include "views/two_view/homography.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/ransac.h"
#include "views/two_view/refinement.h"
#include "views/two_view/residual.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {

namespace {

// Torr's criterion GRIC = sum over the n matches of rho(e^2/sigma^2) + lambda1 d n + lambda2 k,
// where e is a match's residual, rho(x) = min(x, lambda3 (r - d)), lambda1 = log 4, lambda2 = log 4
// n, lambda3 = 2. A match has r = 4 numbers; the model has k parameters and restricts matches to a
// manifold of d dimensions.
struct ModelSize {
  int dimensions, parameters;
};
constexpr ModelSize kFundamental{3, 7}, kHomography{2, 8}, kRotation{2, 3};

template <class SquareOf>
double criterion(const Matches& matches, double sigma, ModelSize size, const SquareOf& square_of) {
  const double count = double(matches.size());
  double sum = logarithm(4.0) * size.dimensions * count + logarithm(4 * count) * size.parameters;
  for (const Match& match : matches) {
    const double most = 2.0 * (4 - size.dimensions);
    sum += std::min(most, square_of(match) / (sigma * sigma));  // a NaN counts as `most`
  }
  return sum;
}

// The rotation that turns the left rays as near as possible to the right rays (Kabsch, Acta
// Crystallographica A32, 1976).
Matrix3d fit_rotation(const Matches& pixels, const Matrix3d& left_intrinsic,
                      const Matrix3d& right_intrinsic) {
  Matrix3d sum = Matrix3d::Zero();
  for (const Match& match : pixels) {
    const Rays rays = rays_of(match, left_intrinsic, right_intrinsic);
    sum += rays.right.normalized() * rays.left.normalized().transpose();
  }
  const Eigen::JacobiSVD<Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3d u = svd.matrixU(), v = svd.matrixV();
  const Vector3d signs(1, 1, (u * v.transpose()).determinant());
  return u * signs.asDiagonal() * v.transpose();
}

// GRIC of a homography.
double cost_of_transfer(const Matches& pixels, const Matrix3d& homography, double sigma,
                        ModelSize size) {
  return criterion(pixels, sigma, size, [&](const Match& match) {
    return transfer_residual(homography, match).squaredNorm();
  });
}

}  // namespace

const char* name_of(PairKind kind) {
  switch (kind) {
    case PairKind::kGeneral:
      return "general";
    case PairKind::kPureRotation:
      return "one point of view";
    case PairKind::kPlane:
      return "a plane";
    case PairKind::kCritical:
      return "a critical surface";
  }
  return "";
}

Result<PairClassification> classify_pair(const Matches& pixels, const Matrix3d& left_intrinsic,
                                         const Matrix3d& right_intrinsic, double sigma) {
  const auto fit = fit_fundamental(pixels, Conditioning::kNormalised);
  if (!fit) return tl::unexpected(fit.error());
  auto homography = estimate_homography(pixels, 3 * sigma);
  if (!homography) return tl::unexpected(homography.error());
  const Matrix3d f = refined_fundamental(fit->matrix, pixels);
  // If the camera only turned, the matches that agree with one homography are all but outliers.
  const Matrix3d rotation =
      fit_rotation(inliers_of(pixels, homography->is_inlier), left_intrinsic, right_intrinsic);

  PairClassification classification;
  classification.cost_of_fundamental =
      criterion(pixels, sigma, kFundamental, [&](const Match& match) {
        const double distance = sampson_distance(f, match);
        return distance * distance;
      });
  classification.cost_of_homography =
      cost_of_transfer(pixels, homography->homography, sigma, kHomography);
  classification.homography = std::move(*homography);
  classification.cost_of_rotation = cost_of_transfer(
      pixels, right_intrinsic * rotation * left_intrinsic.inverse(), sigma, kRotation);
  const auto& values = fit->system.singular_values;
  classification.eighth_over_ninth = values[7] / values[8];

  const double simpler =
      std::min(classification.cost_of_homography, classification.cost_of_rotation);
  const bool is_family = fit->system.rank() < 8 || classification.eighth_over_ninth < 3;
  // If the points are on a plane, F is one member of a family with two parameters, and the fit has
  // chosen the member that suits the noise best. So F has two more parameters than kFundamental
  // says.
  const double freedom = is_family ? 2 * logarithm(4.0 * double(pixels.size())) : 0;
  if (simpler <= classification.cost_of_fundamental + freedom) {
    classification.kind =
        classification.cost_of_rotation == simpler ? PairKind::kPureRotation : PairKind::kPlane;
  } else if (is_family) {
    classification.kind = PairKind::kCritical;
  }
  return classification;
}

}  // namespace glassbox::views
