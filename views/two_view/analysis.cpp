#include "views/two_view/analysis.h"

#include <cmath>

#include <Eigen/SVD>

#include "views/two_view/linear_fit.h"
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
  if (is_decided(classification->kind, request)) {
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
