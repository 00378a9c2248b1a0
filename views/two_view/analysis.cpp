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

// The analysis when no sample determines a model: then all matches may be on one plane, or be seen
// from one point, which gives rank 6. With a lower rank, there is too little information for any
// judgement.
Result<PairAnalysis> undecided_analysis(const PairQuestion& question, const Error& error) {
  constexpr int kRankOfPlane = 6;
  PairAnalysis analysis;
  if (facts_of(question.matches).rank < kRankOfPlane) return tl::unexpected(error);
  analysis.is_inlier.assign(question.matches.size(), true);
  analysis.inliers = int(question.matches.size());
  analysis.why_no_model = error;
  return analysis;
}

// The analysis from the samples' model, with a pose if there are intrinsics and one pose has more
// points in front of the cameras than the others.
Result<PairAnalysis> sampled_analysis(const PairQuestion& question) {
  PairAnalysis analysis;
  if (!question.intrinsics) {
    const auto found = estimate_fundamental(question.matches, question.estimator, question.ransac);
    if (!found) return undecided_analysis(question, found.error());
    add_fundamental(*found, analysis);
    return analysis;
  }
  const auto& [left, right] = *question.intrinsics;
  const auto found =
      estimate_pose(question.matches, left, right, question.estimator, question.ransac);
  if (!found) {
    // If the camera only turned, the rays are parallel, and no point is in front. F of the pixels
    // may be enough to recognise this case.
    const Estimator of_pixels =
        question.estimator == Estimator::kFivePoint ? Estimator::kSevenPoint : question.estimator;
    const auto instead = estimate_fundamental(question.matches, of_pixels, question.ransac);
    if (!instead) return undecided_analysis(question, found.error());
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

bool is_decided(PairKind kind, const PairQuestion& question) {
  switch (kind) {
    case PairKind::kGeneral:
      return true;
    case PairKind::kPlane:
      return question.intrinsics && question.estimator == Estimator::kFivePoint;
    case PairKind::kTurned:
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

Result<PairAnalysis> analyse(const PairQuestion& question) {
  auto analysis = sampled_analysis(question);
  if (!analysis) return analysis;
  const Matches good = inliers_of(question.matches, analysis->is_inlier);
  analysis->system = facts_of(good);
  const Matrix3d identity = Matrix3d::Identity();
  const auto intrinsics = question.intrinsics.value_or(std::array{identity, identity});
  const auto judgement = judge_pair(good, intrinsics[0], intrinsics[1], question.sigma);
  if (!judgement) return tl::unexpected(judgement.error());
  analysis->judgement = *judgement;
  if (is_decided(judgement->kind, question)) {
    if (analysis->why_no_model) return tl::unexpected(*analysis->why_no_model);
    add_residuals(question.matches, *analysis);
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
