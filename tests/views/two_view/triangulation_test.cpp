// S2-05, S2-13, C-107 to C-109, D-23: the point that two pixels show.
#include <tests/support/catch.h>

#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {
namespace {

using test::projected_match;
using test::random_point;
using test::random_rig;

TEST_CASE("without noise every triangulator gives the point, and rays have no gap") {
  std::mt19937 random(20);
  for (int i = 0; i < 300; ++i) {
    const StereoRig rig = random_rig(random);
    const Vector3d point = random_point(random, rig);
    const Match pixels = projected_match(point, rig);
    const double angle = std::acos(
        std::min(1.0, point.normalized().dot((point - rig.pose.translation).normalized())));
    if (angle < 0.01) continue;  // nearly along the baseline: rounding errors grow by 1/angle^2
    for (const Triangulator how : kTriangulators) {
      const Triangulated found = triangulate(how, pixels, rig);
      INFO(name_of(how) << " " << i << " angle " << angle);
      REQUIRE(found.is_finite());
      CHECK((found.point.head<3>() - point).norm() < 1e-12 / (angle * angle));
      CHECK(found.gap < 1e-12 / angle);
      CHECK(found.in_front_of_both);
    }
  }
}

TEST_CASE("corrected pixels fulfil the constraint, and no pair nearer to the given ones does") {
  std::mt19937 random(21);
  for (int i = 0; i < 300; ++i) {
    const StereoRig rig = random_rig(random);
    Match pixels = projected_match(random_point(random, rig), rig);
    pixels.left += test::noise(random, 1);
    pixels.right += test::noise(random, 1);
    const Matrix3d f = fundamental_of(rig).normalized();
    const auto moved = [&](const Match& to) {
      return std::hypot((to.left - pixels.left).norm(), (to.right - pixels.right).norm());
    };
    const auto constraint = [&](const Match& m) {
      const double value = m.right.homogeneous().dot(f * m.left.homogeneous());
      return std::abs(value) / std::hypot((f * m.left.homogeneous()).head<2>().norm(),
                                          (f.transpose() * m.right.homogeneous()).head<2>().norm());
    };
    const Match by_roots = corrected_by_roots(pixels, f);
    const Match by_iteration = corrected_by_iteration(pixels, f);
    INFO(i);
    CHECK(constraint(by_roots) < 1e-9);
    CHECK(constraint(by_iteration) < 1e-6);
    // Both find the same optimum; the iteration is only correct to second order.
    CHECK(moved(by_iteration) <= moved(by_roots) * (1 + 1e-3) + 1e-9);
    CHECK(moved(by_roots) <= moved(by_iteration) * (1 + 1e-6) + 1e-9);
  }
}

TEST_CASE("parallel rays meet at infinity, and nothing is NaN (C-107)") {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.translation = {0.1, 0, 0};
  const Match same{{400, 100}, {400, 100}};
  for (const Triangulator how : kTriangulators) {
    const Triangulated found = triangulate(how, same, rig);
    INFO(name_of(how) << " " << found.point.transpose());
    CHECK(found.point.allFinite());
    CHECK_FALSE(found.is_finite());
    CHECK(found.in_front_of_both);
  }
  // A negative disparity corresponds to a point behind the cameras.
  const Triangulated behind = triangulate(Triangulator::kMidpoint, {{400, 100}, {401, 100}}, rig);
  CHECK(behind.point.z() < 0);
  CHECK_FALSE(behind.in_front_of_both);
}

double standard_deviation(const std::vector<double>& numbers) {
  double mean = 0, square = 0;
  for (const double x : numbers) mean += x;
  mean /= double(numbers.size());
  for (const double x : numbers) square += (x - mean) * (x - mean);
  return std::sqrt(square / double(numbers.size() - 1));
}

TEST_CASE("sigma_Z = Z^2 sqrt(2) sigma/(f B), and all triangulators have it (S2-13)") {
  std::mt19937 random(22);
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.translation = {0.1, 0, 0};
  constexpr double kSigma = 0.25;
  constexpr int kSamples = 4000;
  for (const double depth : {5.0, 10.0, 20.0}) {
    const Vector3d point(0, 0, depth);
    const double law = depth_error_of_parallel(depth, kSigma, 800, 0.1);
    CHECK(std::abs(std::sqrt(covariance_of(point, rig, kSigma)(2, 2)) / law - 1) < 0.01);
    for (const Triangulator how : kTriangulators) {
      std::vector<double> z, x;
      for (int i = 0; i < kSamples; ++i) {
        Match pixels = projected_match(point, rig);
        pixels.left += test::noise(random, kSigma);
        pixels.right += test::noise(random, kSigma);
        const Vector4d found = triangulate(how, pixels, rig).point;
        // The deviation of 1/Z, which has no long tail, gives that of Z: sigma_Z = Z^2 sigma_(1/Z).
        z.push_back(1 / found.z());
        x.push_back(found.x());
      }
      INFO(name_of(how) << " at " << depth);
      // The deviation of a standard deviation of 4000 samples is 1/sqrt(8000); four deviations are
      // allowed.
      CHECK(std::abs(depth * depth * standard_deviation(z) / law - 1) < 4 / std::sqrt(8000.0));
      CHECK(law / standard_deviation(x) > 30);
    }
  }
}

TEST_CASE("the depth's error grows without bound as the baseline goes to 0 (C-109)") {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  double before = 0;
  for (const double baseline : {1e-1, 1e-3, 1e-6}) {
    rig.pose.translation = {baseline, 0, 0};
    const double sigma = std::sqrt(covariance_of({0, 0, 5}, rig, 0.5)(2, 2));
    CHECK(std::abs(sigma / depth_error_of_parallel(5, 0.5, 800, baseline) - 1) < 1e-2);
    CHECK(sigma > 50 * before);
    before = sigma;
  }
  rig.pose.translation.setZero();
  CHECK(std::isinf(covariance_of({0, 0, 5}, rig, 0.5)(2, 2)));
}

}  // namespace
}  // namespace glassbox::views
