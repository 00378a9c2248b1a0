#include "views/two_view/homography.h"

#include <algorithm>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "views/two_view/linear_fit.h"
#include "views/two_view/ransac.h"
#include "views/two_view/residual.h"

namespace glassbox::views {

// Solves p_r x H p_l = 0, the cross product of the right point and the transformed left point,
// which gives two independent equations for each match.
Result<Eigen::Matrix3d> fit_homography(const Matches& matches) {
  if (matches.size() < 4) {
    return fail("the matches", fmt::format("there are {}, but 4 are needed", matches.size()),
                "give more matches");
  }
  return normalised(matches).and_then([&](const Normalised& from) -> Result<Eigen::Matrix3d> {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(Eigen::Index(2 * matches.size()), 9);
    for (Eigen::Index i = 0; i < Eigen::Index(matches.size()); ++i) {
      const Match& match = from.matches[std::size_t(i)];
      const Eigen::RowVector3d left = match.left.homogeneous().transpose();
      rows.row(2 * i) << -left, Eigen::RowVector3d::Zero(), match.right.x() * left;
      rows.row(2 * i + 1) << Eigen::RowVector3d::Zero(), -left, match.right.y() * left;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner> svd(
        rows, Eigen::ComputeFullV);
    const Eigen::Matrix<double, 9, 1> entries = svd.matrixV().col(8);
    const Eigen::Matrix3d there = entries.reshaped<Eigen::RowMajor>(3, 3);
    const Eigen::Matrix3d h = (from.right.inverse() * there * from.left).normalized();
    const double determinant = h.determinant();
    if (determinant == 0) {
      return fail("the matches", "too many of their points are on one line",
                  "give at least four matches of which no three points are on one line");
    }
    return determinant < 0 ? Eigen::Matrix3d(-h) : h;
  });
}

std::vector<bool> matches_within(double threshold, const Eigen::Matrix3d& homography,
                                 const Matches& pixels) {
  std::vector<bool> is_near;
  for (const Match& match : pixels) {
    is_near.push_back(transfer_residual(homography, match).norm() <= threshold);
  }
  return is_near;
}

namespace {

// The homography of the matches that agree with `first`, which are chosen again a few times.
Eigen::Matrix3d refitted(const Eigen::Matrix3d& first, const Matches& matches, double threshold) {
  constexpr int kRounds = 3;
  Eigen::Matrix3d homography = first;
  for (int round = 0; round < kRounds; ++round) {
    const auto next =
        fit_homography(inliers_of(matches, matches_within(threshold, homography, matches)));
    if (!next) break;
    homography = *next;
  }
  return homography;
}

}  // namespace

Result<HomographyEstimate> estimate_homography(const Matches& pixels, double threshold) {
  RansacModel model;
  model.sample_size = 4;
  model.fit = [](const Matches& sample) {
    const auto homography = fit_homography(sample);
    return homography ? std::vector{*homography} : std::vector<Eigen::Matrix3d>{};
  };
  model.residual = [](const Eigen::Matrix3d& homography, const Match& match) {
    return transfer_residual(homography, match).norm();
  };
  model.improve = refitted;
  RansacOptions options;
  options.threshold = threshold;
  options.confidence = 0.9999;
  options.most_samples = 150;  // as many as half of the matches need, with this confidence
  const auto found = ransac(pixels, model, options);
  if (!found) {
    return fail("the matches", "no four of them determine a homography",
                "give at least four matches of which no three points are on one line");
  }
  HomographyEstimate estimate;
  estimate.homography = refitted(found->model, pixels, threshold);
  estimate.is_inlier = matches_within(threshold, estimate.homography, pixels);
  estimate.inliers = int(std::ranges::count(estimate.is_inlier, true));
  return estimate;
}

}  // namespace glassbox::views
