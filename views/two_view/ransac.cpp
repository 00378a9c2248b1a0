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

Matches sample_of(const Matches& matches, Random& random, int size) {
  Matches sample;
  for (const std::size_t i : drawn(random, matches.size(), size)) sample.push_back(matches[i]);
  return sample;
}

// At most some thousand of the matches, evenly chosen.
Matches thinned(const Matches& matches) {
  constexpr std::size_t kEnough = 1000;
  const std::size_t step = 1 + matches.size() / kEnough;
  Matches chosen;
  for (std::size_t i = 0; i < matches.size(); i += step) chosen.push_back(matches[i]);
  return chosen;
}

// A search for the model with the least loss among all matches.
class Search {
public:
  Search(const Matches& matches, const RansacModel& model, double threshold)
      : all_(matches), some_(thinned(matches)), model_(model), threshold_(threshold) {}

  const Eigen::Matrix3d& best() const { return best_; }
  const Score& best_score() const { return best_score_; }

  // The score of a matrix; infinite if its loss is not below this one.
  Score score(const Eigen::Matrix3d& matrix, double below) const {
    return score_of(all_, model_, matrix, threshold_, below);
  }

  void keep_better(const Eigen::Matrix3d& matrix) {
    const Score found = score(matrix, best_score_.loss);
    if (found.loss >= best_score_.loss) return;
    best_ = matrix;
    best_score_ = found;
  }

  // Keeps a matrix, or the one near it that suits all matches best.
  void keep_better_near(const Eigen::Matrix3d& matrix) {
    keep_better(matrix);
    if (model_.improve) keep_better(model_.improve(matrix, some_, threshold_));
  }

  std::vector<bool> inliers() const {
    std::vector<bool> is_inlier;
    for (const Match& match : all_) {
      is_inlier.push_back(std::abs(model_.residual(best_, match)) <= threshold_);
    }
    return is_inlier;
  }

  void go_on_from_best(Random& random);

private:
  const Matches& all_;
  Matches some_;
  const RansacModel& model_;
  double threshold_;
  Eigen::Matrix3d best_ = Eigen::Matrix3d::Zero();
  Score best_score_;
};

// A sample of 14 inliers has a model that is near the best one, but the noise moves it along the
// directions in which the matches determine it least. There the other local minima are.
void Search::go_on_from_best(Random& random) {
  constexpr int kSamples = 20, kSize = 14;
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSamples; ++i) {
    const Matches good = inliers_of(all_, inliers());
    if (int(good.size()) <= kSize) return;
    keep_better_near(model_.improve(best_, sample_of(good, random, kSize), kUnlimited));
  }
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
  Search search(matches, model, options.threshold);
  RansacResult result;
  double best_loss_of_samples = std::numeric_limits<double>::infinity();  // before `improve`
  double needed = options.most_samples;
  for (; result.samples < needed; ++result.samples) {
    for (const Eigen::Matrix3d& matrix : model.fit(sample_of(matches, random, model.sample_size))) {
      const Score score = search.score(matrix, best_loss_of_samples);
      if (score.loss >= best_loss_of_samples) continue;
      best_loss_of_samples = score.loss;
      search.keep_better_near(matrix);
      const double share = double(search.best_score().inliers) / double(matches.size());
      needed = std::min(samples_needed(share, model.sample_size, options.confidence),
                        double(options.most_samples));
    }
  }
  if (std::isinf(search.best_score().loss)) return {};
  if (model.improve) search.go_on_from_best(random);
  result.model = search.best();
  result.is_inlier = search.inliers();
  result.inliers = search.best_score().inliers;
  return result;
}

Matches inliers_of(const Matches& matches, const std::vector<bool>& is_inlier) {
  Matches inliers;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (is_inlier[i]) inliers.push_back(matches[i]);
  }
  return inliers;
}

}  // namespace glassbox::views
