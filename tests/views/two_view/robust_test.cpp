// Noise and outliers: random samples, refinement, and which model a pair supports.
#include <tests/support/catch.h>

#include <cmath>
#include <numbers>

#include <glassbox/base/trig.h>

#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/constraint.h"
#include "views/two_view/estimate.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/pair_kind.h"
#include "views/two_view/pose.h"
#include "views/two_view/ransac.h"
#include "views/two_view/refinement.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {
namespace {

using test::projected_match;
using test::random_matches;
using test::random_rig;

TEST_CASE("as many samples as the law says (D-22)") {
  CHECK(std::ceil(samples_needed(0.5, 5, 0.99)) == 146);  // 145.05
  CHECK(std::floor(samples_needed(0.5, 5, 0.99)) == 145);
  CHECK(std::lround(samples_needed(0.5, 8, 0.99)) == 1177);
  CHECK(samples_needed(1, 5, 0.99) == 1);
  CHECK(std::isinf(samples_needed(0, 5, 0.99)));
}

TEST_CASE("Sampson's distance is how far the nearest pair is, to first order") {
  std::mt19937 random(30);
  for (int i = 0; i < 100; ++i) {
    const StereoRig rig = random_rig(random);
    Match pixels = projected_match(test::random_point(random, rig), rig);
    pixels.left += test::noise(random, 1);
    pixels.right += test::noise(random, 1);
    const Matrix3d f = fundamental_of(rig);
    const Match nearest = corrected_by_roots(pixels, f);
    const double moved =
        std::hypot((nearest.left - pixels.left).norm(), (nearest.right - pixels.right).norm());
    CHECK(std::abs(std::abs(sampson_distance(f, pixels)) - moved) < 0.02 * moved + 1e-9);
  }
}

// The matches with this share of them replaced by random points.
Matches with_outliers(std::mt19937& random, Matches matches, double share) {
  const auto count = std::size_t(share * double(matches.size()));
  for (std::size_t i = 0; i < count; ++i) {
    matches[i].right = {test::uniform(random, 0, 640), test::uniform(random, 0, 480)};
  }
  return matches;
}

struct Estimated {
  double rotation, direction;  // errors in degrees
};

std::optional<Estimated> pose_errors(const StereoRig& rig, const Matches& pixels,
                                     Estimator estimator, const RansacOptions& options) {
  const auto found =
      estimate_pose(pixels, rig.left_intrinsic, rig.right_intrinsic, estimator, options);
  if (!found) return {};
  return Estimated{
      degrees_from_radians(rotation_error(found->pose.rotation, rig.pose.rotation)),
      degrees_from_radians(direction_error(found->pose.translation, rig.pose.translation))};
}

TEST_CASE("half outliers and a pixel of noise: within 0.2 and 1 degree on 95 of 100 seeds") {
  int good = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    StereoRig rig = random_rig(random);
    rig.pose.translation.normalize();
    const Matches pixels = with_outliers(random, random_matches(random, rig, 2000, 1), 0.5);
    RansacOptions options;
    options.threshold = 3;
    options.seed = seed;
    const auto off = pose_errors(rig, pixels, Estimator::kFivePoint, options);
    const bool is_good = off && off->rotation <= 0.2 && off->direction <= 1;
    good += is_good;
    if (!is_good && off)
      UNSCOPED_INFO(seed << ": " << off->rotation << " " << off->direction << "; T "
                         << rig.pose.translation.transpose());
  }
  CHECK(good >= 95);
}

// The sum of squared distances, each limited to the threshold.
double loss_of(const RelativePose& pose, const StereoRig& rig, const Matches& pixels,
               double threshold) {
  const Matrix3d f = fundamental_of({rig.left_intrinsic, rig.right_intrinsic, pose});
  double sum = 0;
  for (const Match& m : pixels) {
    sum += std::pow(std::min(threshold, std::abs(sampson_distance(f, m))), 2);
  }
  return sum;
}

TEST_CASE("of far points with half outliers, the pose fits as well as the one from the truth") {
  // Points of a small depth at a large distance leave the sum of squares a long valley with many
  // local minima.
  int good = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const StereoRig rig = random_rig(random);
    constexpr double kSigma = 0.5, kThreshold = 2 * kSigma;
    const Matches pixels =
        with_outliers(random, random_matches(random, rig, 400, kSigma, 8, 10), 0.5);
    RansacOptions options;
    options.threshold = kThreshold;
    options.seed = seed;
    const auto found = estimate_pose(pixels, rig.left_intrinsic, rig.right_intrinsic,
                                     Estimator::kFivePoint, options);
    REQUIRE(found);
    const RelativePose from_truth = refined_pose(rig, pixels, kThreshold);
    const double least = loss_of(from_truth, rig, pixels, kThreshold);
    const double own = loss_of(found->pose, rig, pixels, kThreshold);
    UNSCOPED_INFO(seed << ": " << own << ", from the truth " << least);
    good += own < least + 5 * kSigma * kSigma;
  }
  CHECK(good >= 38);
}

TEST_CASE("refinement lessens the distances, and finds what has none") {
  std::mt19937 random(31);
  for (int i = 0; i < 20; ++i) {
    const StereoRig rig = random_rig(random);
    const Matches noisy = random_matches(random, rig, 50, 0.5);
    const auto sum = [&](const Matrix3d& f, const Matches& matches) {
      double total = 0;
      for (const Match& m : matches) total += std::pow(sampson_distance(f, m), 2);
      return total;
    };
    const Matrix3d first = fit_fundamental(noisy, Conditioning::kNormalised)->matrix;
    const Matrix3d f = refined_fundamental(first, noisy);
    CHECK(sum(f, noisy) <= sum(first, noisy));
    // As good as the true matrix, which is among the possible results.
    CHECK(sum(f, noisy) <= sum(fundamental_of(rig), noisy) * (1 + 1e-6));

    StereoRig off = rig;
    off.pose.rotation *= Eigen::AngleAxisd(0.02, test::random_direction(random)).matrix();
    off.pose.translation += 0.02 * test::random_direction(random);
    const Matches exact = random_matches(random, rig, 50);
    const RelativePose pose = refined_pose(off, exact);
    CHECK(rotation_error(pose.rotation, rig.pose.rotation) < 1e-7);
    CHECK(direction_error(pose.translation, rig.pose.translation) < 1e-6);
    CHECK(std::abs(pose.translation.norm() - off.pose.translation.norm()) < 1e-12);
  }
}

PairKind kind_of(const Matches& pixels, const StereoRig& rig, double sigma) {
  const auto judged = classify_pair(pixels, rig.left_intrinsic, rig.right_intrinsic, sigma);
  REQUIRE(judged);
  UNSCOPED_INFO(judged->cost_of_fundamental << " " << judged->cost_of_homography << " "
                                            << judged->cost_of_rotation << " "
                                            << judged->eighth_over_ninth);
  return judged->kind;
}

TEST_CASE("a turned camera, a plane and a critical surface are named (C-101 to C-103)") {
  std::mt19937 random(32);
  for (int i = 0; i < 20; ++i) {
    INFO(i);
    const StereoRig rig = random_rig(random);
    constexpr double kSigma = 0.5;
    CHECK(kind_of(random_matches(random, rig, 60, kSigma), rig, kSigma) == PairKind::kGeneral);

    StereoRig turned = rig;
    turned.pose.translation.setZero();
    CHECK(kind_of(random_matches(random, turned, 60, kSigma), turned, kSigma) ==
          PairKind::kPureRotation);

    const Vector3d normal =
        (Vector3d(0, 0, -1) + 0.3 * test::random_direction(random)).normalized();
    Matches flat;
    for (int k = 0; k < 60; ++k) {
      const Vector3d ray = test::random_point(random, rig);
      const Vector3d point = ray * (-6 / ray.dot(normal));
      Match match = projected_match(point, rig);
      match.left += test::noise(random, kSigma);
      match.right += test::noise(random, kSigma);
      flat.push_back(match);
    }
    CHECK(kind_of(flat, rig, kSigma) == PairKind::kPlane);
  }
}

TEST_CASE("points on a ruled quadric through both centres leave a second matrix (C-103)") {
  // The points are on the quadric x^2 - x + y z = 0, a ruled hyperboloid. It contains both centres,
  // (0, 0, 0) and (1, 0, 0), but not the line between them.
  std::mt19937 random(33);
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.translation = {1, 0, 0};
  for (const double sigma : {0.0, 0.1}) {
    Matches pixels;
    while (pixels.size() < 60) {
      const double x = test::uniform(random, -1.5, 2.5), z = test::uniform(random, 4, 8);
      const double y = -(x * x - x) / z;
      Match match = projected_match({x, y, z}, rig);
      match.left += test::noise(random, sigma);
      match.right += test::noise(random, sigma);
      pixels.push_back(match);
    }
    INFO(sigma);
    CHECK(kind_of(pixels, rig, sigma > 0 ? sigma : 0.1) == PairKind::kCritical);
  }
}

}  // namespace
}  // namespace glassbox::views
