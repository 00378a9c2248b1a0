#include "views/two_view/analysis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/base/elementary.h>
#include <glassbox/base/trig.h>

#include "views/two_view/constraint.h"
#include "views/two_view/homography.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/pose.h"
#include "views/two_view/refinement.h"
#include "views/two_view/residual.h"

namespace glassbox::views {

namespace {

SystemFacts facts_of(const Matches& matches) {
  SystemFacts facts;
  if (const auto raw = linear_fit(matches)) facts.condition_raw = raw->condition();
  if (const auto from = normalised(matches)) {
    if (const auto fit = linear_fit(from->matches)) {
      facts.rank = fit->rank();
      facts.condition_normalised = fit->condition();
    }
  }
  return facts;
}

void add_fundamental(const FundamentalEstimate& found, PairAnalysis& analysis) {
  analysis.fundamental = found.fundamental.normalized();
  analysis.is_inlier = found.is_inlier;
  analysis.inliers = found.inliers;
  analysis.samples = found.samples;
}

// The analysis when no sample of matches determines a model. Then all points may be on one plane,
// or the camera may only have turned; in both cases the linear system has rank 6. With a lower
// rank, there is too little information for any classification.
Result<PairAnalysis> undecided_analysis(const PairRequest& request, const Error& error) {
  constexpr int kRankOfPlane = 6;
  PairAnalysis analysis;
  if (facts_of(request.matches).rank < kRankOfPlane) return tl::unexpected(error);
  analysis.is_inlier.assign(request.matches.size(), true);
  analysis.inliers = int(request.matches.size());
  analysis.why_no_model = error;
  return analysis;
}

// The analysis from the model that the random samples give. It has a pose if there are intrinsics
// and one of the four possible poses has more points in front of the cameras than the other three.
Result<PairAnalysis> sampled_analysis(const PairRequest& request) {
  PairAnalysis analysis;
  if (!request.intrinsics) {
    const auto found = estimate_fundamental(request.matches, request.estimator, request.ransac);
    if (!found) return undecided_analysis(request, found.error());
    add_fundamental(*found, analysis);
    return analysis;
  }
  const auto& [left, right] = *request.intrinsics;
  const auto found = estimate_pose(request.matches, left, right, request.estimator, request.ransac);
  if (!found) {
    // If the camera only turned, the rays of a match are parallel, and no point is in front of the
    // cameras. F of the pixels may be enough to recognise this case.
    const Estimator of_pixels =
        request.estimator == Estimator::kFivePoint ? Estimator::kSevenPoint : request.estimator;
    const auto instead = estimate_fundamental(request.matches, of_pixels, request.ransac);
    if (!instead) return undecided_analysis(request, found.error());
    add_fundamental(*instead, analysis);
    analysis.why_no_model = found.error();
    return analysis;
  }
  analysis.pose = found->pose;
  analysis.fundamental = fundamental_of({left, right, found->pose}).normalized();
  analysis.is_inlier = found->is_inlier;
  analysis.inliers = found->inliers;
  analysis.samples = found->samples;
  analysis.in_front = found->in_front;
  return analysis;
}

// Makes this pose the result, with the matches that agree with it as inliers.
void use_pose(const PairRequest& request, const RelativePose& pose, PairAnalysis& analysis) {
  const auto& [left, right] = *request.intrinsics;
  analysis.pose = pose;
  analysis.fundamental = fundamental_of({left, right, pose}).normalized();
  analysis.is_inlier =
      matches_near(*analysis.fundamental, request.matches, request.ransac.threshold);
  analysis.inliers = int(std::ranges::count(analysis.is_inlier, true));
  analysis.in_front = in_front_of_both(
      pose, calibrated(inliers_of(request.matches, analysis.is_inlier), left, right));
}

bool is_decided(PairKind kind, const PairRequest& request) {
  switch (kind) {
    case PairKind::kGeneral:
      return true;
    case PairKind::kPlane:
      return request.intrinsics && request.estimator == Estimator::kFivePoint;
    case PairKind::kPureRotation:
    case PairKind::kCritical:
      break;
  }
  return false;
}

// Replaces the pose of the random samples by that of the plane. Both solutions for a plane fulfil
// the epipolar constraint equally well, so the samples give either of them.
void use_plane(const PairRequest& request, PairAnalysis& analysis) {
  const auto& [left, right] = *request.intrinsics;
  const Matrix3d& homography = analysis.classification.homography.homography;
  analysis.plane =
      analyse_plane({request.matches, left, right, request.sigma, request.ransac.threshold},
                    homography, matches_within(3 * request.sigma, homography, request.matches));
  if (!analysis.plane) return;
  analysis.why_no_model.reset();
  use_pose(request, analysis.plane->solutions[0].found.pose, analysis);
  // More points beside the plane agree with the pose than by chance: they are not outliers, as the
  // criterion has taken them for.
  if (analysis.plane->evidence == PlaneEvidence::kOthers)
    analysis.classification.kind = PairKind::kGeneral;
}

// The matrices a F1 + b F2 that the equations of the eight-point algorithm leave for a critical
// surface, for several a and b. F1 and F2 belong to the two least singular values.
std::vector<Matrix3d> family_of(const Matches& pixels) {
  constexpr int kMembers = 16;
  std::vector<Matrix3d> members;
  const auto from = normalised(pixels);
  if (!from) return members;
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner> svd(
      design_matrix(from->matches), Eigen::ComputeFullV);
  for (int i = 0; i < kMembers; ++i) {
    const auto [sine, cosine] = sin_cos(i * std::numbers::pi / kMembers);
    const Eigen::Matrix<double, 9, 1> entries =
        cosine * svd.matrixV().col(7) + sine * svd.matrixV().col(8);
    members.emplace_back(from->right.transpose() * entries.reshaped<Eigen::RowMajor>(3, 3) *
                         from->left);
  }
  return members;
}

// Whether another pose fulfils the constraint of these matches about as well as this one: the sum
// of n squared residuals with the error sigma has the standard deviation sqrt(2 n) sigma^2.
bool has_rival(const PairRequest& request, const RelativePose& pose, const Matches& good) {
  const Matrix3d &left = (*request.intrinsics)[0], &right = (*request.intrinsics)[1];
  const auto loss = [&](const RelativePose& one) {
    const Matrix3d f = fundamental_of({left, right, one});
    double sum = 0;
    for (const Match& match : good) sum += whole_power(sampson_distance(f, match), 2);
    return sum;
  };
  const double count = double(good.size());
  const double most = loss(pose) + 3 * std::sqrt(4 * count) * request.sigma * request.sigma;
  for (const Matrix3d& member : family_of(good)) {
    const RelativePose start = poses_of(nearest_essential(right.transpose() * member * left))[0];
    const RelativePose other = refined_pose({left, right, start}, good);
    constexpr double kSame = 0.1;  // of matrices of norm sqrt(2)
    const Matrix3d e = essential<double>(pose.rotation, pose.translation);
    const Matrix3d another = essential<double>(other.rotation, other.translation);
    const bool is_other = std::min((e - another).norm(), (e + another).norm()) > kSame;
    if (is_other && loss(other) <= most) return true;
  }
  return false;
}

void add_residuals(const Matches& matches, PairAnalysis& analysis) {
  double squares = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    analysis.residuals.push_back(std::abs(sampson_distance(*analysis.fundamental, matches[i])));
    if (analysis.is_inlier[i]) squares += analysis.residuals[i] * analysis.residuals[i];
  }
  analysis.rms = std::sqrt(squares / analysis.inliers);
}

}  // namespace

Result<PairAnalysis> analyse(const PairRequest& request) {
  auto analysis = sampled_analysis(request);
  if (!analysis) return analysis;
  const Matches good = inliers_of(request.matches, analysis->is_inlier);
  analysis->system = facts_of(good);
  const Matrix3d identity = Matrix3d::Identity();
  const auto intrinsics = request.intrinsics.value_or(std::array{identity, identity});
  const auto classification = classify_pair(good, intrinsics[0], intrinsics[1], request.sigma);
  if (!classification) return tl::unexpected(classification.error());
  analysis->classification = *classification;
  if (classification->kind == PairKind::kCritical && analysis->pose &&
      request.estimator == Estimator::kFivePoint && !has_rival(request, *analysis->pose, good)) {
    analysis->classification.kind = PairKind::kGeneral;
    analysis->is_only_essential = true;
  }
  const PairKind kind = analysis->classification.kind;
  const bool is_decided_kind = is_decided(kind, request);
  if (is_decided_kind && kind == PairKind::kPlane) use_plane(request, *analysis);
  if (is_decided_kind) {
    if (analysis->why_no_model) return tl::unexpected(*analysis->why_no_model);
    add_residuals(request.matches, *analysis);
  } else {
    analysis->fundamental.reset();
    analysis->pose.reset();
  }
  return analysis;
}

namespace {

Vector3d with_positive_weight(const Vector3d& point) {
  return point.z() < 0 ? Vector3d(-point) : point;
}

}  // namespace

Vector3d epipole_left(const Matrix3d& fundamental) {
  const Eigen::JacobiSVD<Matrix3d> svd(fundamental, Eigen::ComputeFullV);
  return with_positive_weight(svd.matrixV().col(2));
}

Vector3d epipole_right(const Matrix3d& fundamental) {
  return epipole_left(fundamental.transpose());
}

}  // namespace glassbox::views
