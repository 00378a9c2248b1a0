// S2-12: matrices estimated from matches, and the cameras derived from them.
#include <tests/support/catch.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/constraint.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/minimal_solvers.h"
#include "views/two_view/polynomial.h"
#include "views/two_view/pose.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {
namespace {

using test::calibrated;
using test::matrix_distance;
using test::random_matches;
using test::random_rig;

Matrix3d true_essential(const StereoRig& rig) {
  return essential<double>(rig.pose.rotation, rig.pose.translation);
}

TEST_CASE("real roots, of single and double ones, and of leading zeros") {
  // (x - 1)(x - 2)(x + 3) = x^3 - 7 x + 6.
  Eigen::VectorXd cubic(4);
  cubic << 6, -7, 0, 1;
  const std::vector<double> three = real_roots(cubic);
  REQUIRE(three.size() == 3);
  CHECK(std::abs(three[0] + 3) < 1e-14);
  CHECK(std::abs(three[2] - 2) < 1e-14);
  Eigen::VectorXd square(5);  // (x - 1)^2 (x^2 + 1), with coefficient 0 for degree 5
  square << 1, -2, 2, -2, 1;
  const std::vector<double> both = real_roots(square);
  REQUIRE(both.size() == 2);
  CHECK(std::abs(both[0] - 1) < 1e-7);
  Eigen::VectorXd line(3);
  line << -4, 2, 0;
  CHECK(real_roots(line) == std::vector<double>{2});
  CHECK(real_roots(Eigen::VectorXd::Constant(1, 5)).empty());
}

TEST_CASE("eight matches and more give back the matrix that they were made with") {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const StereoRig rig = random_rig(random);
    const Matches pixels = random_matches(random, rig, 8 + i % 40);
    for (const Conditioning how : {Conditioning::kRaw, Conditioning::kNormalised}) {
      const auto e = fit_essential(calibrated(pixels, rig), how);
      REQUIRE(e);
      // Rounding errors times the condition of the system.
      CHECK(matrix_distance(e->matrix, true_essential(rig)) < 64 * 0x1p-53 * e->system.condition());
    }
    const auto f = fit_fundamental(pixels, Conditioning::kNormalised);
    REQUIRE(f);
    // Compared as E, because pixel coordinates are much larger than 1 and the entries of F differ
    // greatly in size.
    const Matrix3d as_essential = rig.right_intrinsic.transpose() * f->matrix * rig.left_intrinsic;
    CHECK(matrix_distance(as_essential, true_essential(rig)) <
          64 * 0x1p-53 * f->system.condition());
  }
}

TEST_CASE("normalised points make the system a thousand times better conditioned (B.8)") {
  std::mt19937 random(4);
  const auto log_of_median = [&](int count, Conditioning how) {
    std::vector<double> logs;
    for (int i = 0; i < 101; ++i) {
      const StereoRig rig = random_rig(random);
      const auto fit = fit_fundamental(random_matches(random, rig, count, 0.5, 4, 8), how);
      REQUIRE(fit);
      logs.push_back(std::log10(fit->system.condition()));
    }
    std::ranges::nth_element(logs, logs.begin() + 50);
    return logs[50];
  };
  for (const auto& [count, raw, normalised] :
       {std::tuple{8, 5.5, 2.3}, std::tuple{20, 4.95, 1.8}, std::tuple{50, 4.7, 1.6}}) {
    const double of_raw = log_of_median(count, Conditioning::kRaw);
    const double gain = of_raw - log_of_median(count, Conditioning::kNormalised);
    INFO(count << " matches: 10^" << gain);
    // A factor of two, and 0.05 for the rounding of each published logarithm.
    CHECK(std::abs(gain - (raw - normalised)) < std::log10(2.0) + 0.1);
  }
}

TEST_CASE(
    "normalised points bring epipolar lines as much nearer as B.8 says, but for a factor of two") {
  std::mt19937 random(4);
  // Medians of the mean distance between clean points and the epipolar lines of a matrix that was
  // fitted to matches with half a pixel of noise.
  const auto median_distances = [&](int count) {
    std::array<std::vector<double>, 2> distances;
    for (int i = 0; i < 101; ++i) {
      const StereoRig rig = random_rig(random);
      const Matches noisy = random_matches(random, rig, count, 0.5, 4, 8);
      const Matches clean = random_matches(random, rig, 200, 0, 4, 8);
      for (const Conditioning how : {Conditioning::kRaw, Conditioning::kNormalised}) {
        const auto fit = fit_fundamental(noisy, how);
        REQUIRE(fit);
        double sum = 0;
        for (const Match& match : clean) sum += epipolar_distance(fit->matrix, match);
        distances[how == Conditioning::kRaw ? 0 : 1].push_back(sum / double(clean.size()));
      }
    }
    for (auto& all : distances) std::ranges::nth_element(all, all.begin() + 50);
    return std::pair{distances[0][50], distances[1][50]};
  };
  struct Published {
    int count;
    double raw, normalised;
  };
  for (const auto& [count, raw, normalised] :
       {Published{20, 1.83, 0.55}, Published{50, 0.45, 0.27}}) {
    const auto [own_raw, own_normalised] = median_distances(count);
    INFO(count << " matches: " << own_raw << " px raw, " << own_normalised << " normalised");
    const double off = (own_raw / own_normalised) / (raw / normalised);
    CHECK(off >= 0.5);
    CHECK(off <= 2);
    CHECK(own_normalised / normalised >= 0.5);
    CHECK(own_normalised / normalised <= 2);
  }
}

TEST_CASE("C-104: a match without a place is refused for what it is, before it is computed with") {
  std::mt19937 random(8);
  const Matches good = random_matches(random, random_rig(random), 12);
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan(""), 1e200}) {
    for (const bool left : {true, false}) {
      Matches matches = good;
      (left ? matches[3].left : matches[3].right).y() = bad;
      std::feclearexcept(FE_ALL_EXCEPT);
      for (const Conditioning how : {Conditioning::kRaw, Conditioning::kNormalised}) {
        // The products of these coordinates are finite doubles.
        if (how == Conditioning::kRaw && std::isfinite(bad)) continue;
        const auto fit = fit_fundamental(matches, how);
        CHECK(std::fetestexcept(FE_INVALID) == 0);
        REQUIRE_FALSE(fit);
        CHECK(fit.error().cause == "a coordinate is not finite, or too large for the computation");
      }
    }
  }
}

TEST_CASE("seven matches: one of at most three matrices is right, and all fulfil the equations") {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const StereoRig rig = random_rig(random);
    const Matches pixels = random_matches(random, rig, 7);
    const auto found = seven_point(pixels);
    REQUIRE(found);
    REQUIRE(!found->empty());
    CHECK(found->size() <= 3);
    double nearest = 1;
    for (const Matrix3d& f : *found)
      nearest = std::min(nearest, matrix_distance(f, fundamental_of(rig)));
    CHECK(nearest < 1e-6);
  }
}

TEST_CASE("five calibrated matches: one of at most ten matrices is right, and all are essential") {
  std::mt19937 random(6);
  for (int i = 0; i < 500; ++i) {
    const StereoRig rig = random_rig(random);
    const Matches matches = calibrated(random_matches(random, rig, 5), rig);
    const auto found = five_point(matches);
    REQUIRE(found);
    CHECK(found->size() <= 10);
    double nearest = 1;
    for (const Matrix3d& e : *found) {
      nearest = std::min(nearest, matrix_distance(e, true_essential(rig)));
      for (const Match& m : matches) {
        CHECK(std::abs(m.right.homogeneous().dot(e * m.left.homogeneous())) < 1e-10);
      }
    }
    INFO(i);
    CHECK(nearest < 1e-6);
  }
}

TEST_CASE("five matches of a plane, a pure step along an axis, and rectified pictures") {
  std::mt19937 random(7);
  for (const Vector3d& step : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
    StereoRig rig = random_rig(random);
    rig.pose.rotation.setIdentity();
    rig.pose.translation = 0.5 * step;
    for (const bool flat : {false, true}) {
      Matches pixels;
      for (int i = 0; i < 5; ++i) {
        const Vector3d point = test::random_point(random, rig);
        pixels.push_back(
            test::projected_match(flat ? Vector3d(5 * point / point.z()) : point, rig));
      }
      const auto found = five_point(calibrated(pixels, rig));
      REQUIRE(found);
      double nearest = 1;
      for (const Matrix3d& e : *found)
        nearest = std::min(nearest, matrix_distance(e, true_essential(rig)));
      INFO(step.transpose() << " " << flat);
      CHECK(nearest < 1e-5);
    }
  }
}

TEST_CASE("one of the four poses sees all matches in front of both cameras (C-105)") {
  std::mt19937 random(8);
  for (int i = 0; i < 200; ++i) {
    const StereoRig rig = random_rig(random);
    const Matches matches = calibrated(random_matches(random, rig, 20), rig);
    const auto chosen = pose_in_front(true_essential(rig), matches);
    REQUIRE(chosen);
    CHECK(chosen->in_front == 20);
    CHECK(rotation_error(chosen->pose.rotation, rig.pose.rotation) < 1e-13);
    CHECK(direction_error(chosen->pose.translation, rig.pose.translation) < 1e-13);
    // Each of the four poses gives E up to its sign.
    for (const RelativePose& pose : poses_of(true_essential(rig))) {
      CHECK(matrix_distance(essential<double>(pose.rotation, pose.translation),
                            true_essential(rig)) < 1e-14);
    }
  }
}

TEST_CASE("too few, coincident, or infinite points are refused (C-104)") {
  std::mt19937 random(9);
  const StereoRig rig = random_rig(random);
  Matches matches = random_matches(random, rig, 7);
  CHECK_FALSE(fit_fundamental(matches, Conditioning::kNormalised));
  const Matches same(8, matches.front());
  CHECK_FALSE(fit_fundamental(same, Conditioning::kNormalised));
  CHECK(linear_fit(same)->rank() == 1);
  CHECK_FALSE(seven_point(Matches(7, matches.front())));
  CHECK_FALSE(five_point(Matches(5, matches.front())));
  matches.push_back({{1e200, 0}, {1e200, 0}});
  CHECK_FALSE(linear_fit(matches));
}

TEST_CASE("a plane leaves rank 6, which is reported (C-102)") {
  std::mt19937 random(10);
  const StereoRig rig = random_rig(random);
  Matches pixels;
  for (int i = 0; i < 20; ++i) {
    const Vector3d point = test::random_point(random, rig);
    pixels.push_back(test::projected_match(5 * point / point.z(), rig));
  }
  CHECK(linear_fit(normalised(pixels)->matches)->rank() == 6);
  CHECK(linear_fit(normalised(random_matches(random, rig, 20))->matches)->rank() == 8);
}

TEST_CASE("singular values are made equal after carrying back (C-106)") {
  std::mt19937 random(11);
  double before = 0, after = 0;
  for (int i = 0; i < 50; ++i) {
    const StereoRig rig = random_rig(random);
    const Matches matches = calibrated(random_matches(random, rig, 20, 0.5), rig);
    const auto from = normalised(matches);
    const auto fit = linear_fit(from->matches);
    const Matrix3d wrong = from->right.transpose() * nearest_essential(fit->matrix) * from->left;
    before += demazure<double>(wrong.normalized()).norm();
    after +=
        demazure<double>(fit_essential(matches, Conditioning::kNormalised)->matrix.normalized())
            .norm();
  }
  CHECK(after < 50 * 1e-15);
  CHECK(before > 50 * 1e-3);
}

}  // namespace
}  // namespace glassbox::views
