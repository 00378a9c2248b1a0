#include "views/two_view/ransac.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/elementary.h>
#include <glassbox/base/random.h>

namespace glassbox::views {

namespace {

// Draws `size` different numbers from 0 .. count - 1.
std::vector<std::size_t> drawn(Random& random, std::size_t count, int size) {
  std::vector<std::size_t> chosen;
  while (int(chosen.size()) < size) {
    const auto next = std::size_t(random.integer(0, std::int64_t(count) - 1));
    if (std::ranges::find(chosen, next) == chosen.end()) chosen.push_back(next);
  }
  return chosen;
}

struct Score {
  double loss = std::numeric_limits<double>::infinity();
  int inliers = 0;
};

Score score_of(const Matches& matches, const RansacModel& model, const Eigen::Matrix3d& matrix,
               double threshold, double best_loss) {
  Score score{0, 0};
  const double most = threshold * threshold;
  for (const Match& match : matches) {
    const double residual = model.residual(matrix, match);
    const double square = residual * residual;
    score.inliers += square <= most;
    score.loss += std::isnan(square) ? most : std::min(square, most);
    if (score.loss >= best_loss) return {};
  }
  return score;
}

}  // namespace

double samples_needed(double inlier_share, int size, double confidence) {
  const double good = whole_power(inlier_share, size);
  if (good >= 1) return 1;
  if (good <= 0) return std::numeric_limits<double>::infinity();
  return std::max(1.0, logarithm_1p(-confidence) / logarithm_1p(-good));
}

std::optional<RansacResult> ransac(const Matches& matches, const RansacModel& model,
                                   const RansacOptions& options) {
  if (int(matches.size()) < model.sample_size) return {};
  Random random(options.seed);
  RansacResult best;
  Score best_score;
  double needed = options.most_samples;
  for (; best.samples < std::min(needed, double(options.most_samples)); ++best.samples) {
    Matches sample;
    for (const std::size_t i : drawn(random, matches.size(), model.sample_size)) {
      sample.push_back(matches[i]);
    }
    for (const Eigen::Matrix3d& matrix : model.fit(sample)) {
      const Score score = score_of(matches, model, matrix, options.threshold, best_score.loss);
      if (score.loss >= best_score.loss) continue;
      best_score = score;
      best.model = matrix;
      needed = samples_needed(double(score.inliers) / double(matches.size()), model.sample_size,
                              options.confidence);
    }
  }
  if (std::isinf(best_score.loss)) return {};
  for (const Match& match : matches) {
    best.is_inlier.push_back(std::abs(model.residual(best.model, match)) <= options.threshold);
  }
  best.inliers = best_score.inliers;
  return best;
}

Matches inliers_of(const Matches& matches, const std::vector<bool>& is_inlier) {
  Matches inliers;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (is_inlier[i]) inliers.push_back(matches[i]);
  }
  return inliers;
}

}  // namespace glassbox::views
