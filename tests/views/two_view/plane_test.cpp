// Cameras that see a plane (C-102): a homography has two poses, and which of them is right.
#include <tests/support/catch.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glassbox/base/trig.h>

#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/analysis.h"
#include "views/two_view/plane_pose.h"
#include "views/two_view/pose.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {
namespace {

using test::uniform;

// A pair of cameras, and a plane before them: its points P have plane . P = 1.
struct FlatScene {
  StereoRig rig;
  Vector3d plane;
};

// The plane is 3 to 8 away and leans in any direction, by up to about 50 degrees.
FlatScene random_flat_scene(std::mt19937& random) {
  const StereoRig rig = test::random_rig(random);
  const Vector3d lean = test::random_direction(random);
  const Vector3d normal = (Vector3d(0, 0, 1) + uniform(random, 0, 0.8) * lean).normalized();
  return {rig, normal / uniform(random, 3, 8)};
}

// Both cameras see the point of the plane on this ray, up to 40 away.
bool is_seen(const Vector3d& ray, const FlatScene& scene) {
  const double inverse_depth = scene.plane.dot(ray);
  if (inverse_depth < 1.0 / 40) return false;
  const auto& [rotation, translation] = scene.rig.pose;
  return (rotation * (ray / inverse_depth - translation)).z() > 0.3;
}

// A match of a random point: on the plane, or beside it at a random distance.
Match random_match(std::mt19937& random, const FlatScene& scene, double sigma, bool on_plane) {
  for (;;) {
    const Vector2d pixel{uniform(random, 0, 640), uniform(random, 0, 480)};
    const Vector3d ray = ray_through(scene.rig.left_intrinsic, pixel);
    const double nearer = on_plane ? 1 : uniform(random, 0.4, 0.8);
    if (!is_seen(ray, scene)) continue;
    const Vector3d point = nearer / scene.plane.dot(ray) * ray;
    if ((scene.rig.pose.rotation * (point - scene.rig.pose.translation)).z() < 0.3) continue;
    Match match = test::projected_match(point, scene.rig);
    match.left += test::noise(random, sigma);
    match.right += test::noise(random, sigma);
    return match;
  }
}

Matches flat_matches(std::mt19937& random, const FlatScene& scene, int count, double sigma) {
  Matches matches;
  while (int(matches.size()) < count) {
    matches.push_back(random_match(random, scene, sigma, true));
  }
  return matches;
}

// With T and the plane's vector m, the homography is H = R (I - T m^T), and H^T H - I = m w^T + w
// m^T with w = |T|^2 m/2 - T. So w is the normal of the other plane that explains it.
Vector3d other_normal(const FlatScene& scene) {
  const Vector3d& t = scene.rig.pose.translation;
  return (t.squaredNorm() * scene.plane / 2 - t).normalized();
}

// The share of the matches that are behind the cameras in the other solution.
double share_behind_in_other(const FlatScene& scene, const Matches& matches) {
  const Vector3d normal = other_normal(scene);
  const auto in_front = std::ranges::count_if(matches, [&](const Match& match) {
    return normal.dot(ray_through(scene.rig.left_intrinsic, match.left)) > 0;
  });
  const double share = double(in_front) / double(matches.size());
  return std::min(share, 1 - share);
}

PairRequest request_for(const StereoRig& rig, const Matches& matches, double sigma,
                        std::uint64_t seed = 1) {
  PairRequest request;
  request.matches = matches;
  request.intrinsics = {rig.left_intrinsic, rig.right_intrinsic};
  request.sigma = std::max(sigma, 0.05);
  request.ransac.threshold = 2 * request.sigma;
  request.ransac.seed = seed;
  return request;
}

struct PoseErrors {
  double rotation, direction;  // degrees
};

PoseErrors errors_of(const RelativePose& found, const RelativePose& truth) {
  return {degrees_from_radians(rotation_error(found.rotation, truth.rotation)),
          degrees_from_radians(direction_error(found.translation, truth.translation))};
}

bool is_undecided(const PairAnalysis& analysis) {
  return analysis.plane && analysis.plane->evidence == PlaneEvidence::kNothing;
}

// The errors of the pose that was chosen, or of the nearer one where both are reported.
PoseErrors least_errors(const PairAnalysis& analysis, const RelativePose& truth) {
  const PoseErrors first = errors_of(*analysis.pose, truth);
  if (!is_undecided(analysis)) return first;
  const PoseErrors second = errors_of(analysis.plane->solutions[1].found.pose, truth);
  return first.direction + first.rotation < second.direction + second.rotation ? first : second;
}

}  // namespace

TEST_CASE("a homography has two poses: the true one, and one whose plane is known (C-102)") {
  std::mt19937 random(50);
  for (int i = 0; i < 1000; ++i) {
    INFO(i);
    const FlatScene scene = random_flat_scene(random);
    const Matches matches = flat_matches(random, scene, 12, 0);
    const double scale = uniform(random, 0.5, 2) * (i % 2 == 0 ? 1 : -1);
    const StereoRig of_rays{Matrix3d::Identity(), Matrix3d::Identity(), scene.rig.pose};
    const Matrix3d homography = homography_of(of_rays, scene.plane);
    const auto poses =
        poses_of_homography(scale * homography, test::calibrated(matches, scene.rig));
    REQUIRE(poses);
    const auto off = [&](const PlanePose& one) {
      return errors_of(one.pose, scene.rig.pose).rotation;
    };
    const bool first_is_true = off((*poses)[0]) < off((*poses)[1]);
    const auto& [right, other] =
        std::tie((*poses)[first_is_true ? 0 : 1], (*poses)[first_is_true ? 1 : 0]);
    // The vectors u of the decomposition lose half of the digits where T is along the normal.
    const double along =
        std::abs(scene.plane.normalized().cross(scene.rig.pose.translation.normalized()).norm());
    const double bound = 1e-11 / along;
    CHECK(rotation_error(right.pose.rotation, scene.rig.pose.rotation) < bound);
    CHECK(direction_error(right.pose.translation, scene.rig.pose.translation) < bound);
    CHECK((right.plane - scene.plane * scene.rig.pose.translation.norm()).norm() < bound);
    CHECK(other.plane.normalized().cross(other_normal(scene)).norm() < bound);
    for (const PlanePose& one : *poses) {
      CHECK(std::abs(one.pose.translation.norm() - 1) < 1e-14);
      const Matrix3d again =
          homography_of({Matrix3d::Identity(), Matrix3d::Identity(), one.pose}, one.plane);
      CHECK(test::matrix_distance(again, homography) < 1e-12);
    }
  }
}

TEST_CASE("the right camera from a plane, or both that are possible (C-102)") {
  for (const auto& [sigma, outliers, rotation, direction] :
       {std::array{0.0, 0.0, 1e-3, 1e-2}, std::array{0.0, 0.3, 1e-3, 1e-2},
        std::array{0.3, 0.0, 1.5, 8.0}, std::array{0.3, 0.4, 1.5, 8.0}}) {
    int decided = 0, impossible_others = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
      std::mt19937 random(seed);
      const FlatScene scene = random_flat_scene(random);
      Matches matches = flat_matches(random, scene, 300, sigma);
      const double behind = share_behind_in_other(scene, matches);
      for (int i = 0; i < int(outliers * 300); ++i) {
        matches[std::size_t(i)].right.x() = uniform(random, 0, 640);
        matches[std::size_t(i)].right.y() = uniform(random, 0, 480);
      }
      INFO("seed " << seed << ", sigma " << sigma << ", outliers " << outliers << ", share behind "
                   << behind << ", T " << scene.rig.pose.translation.transpose() << ", plane "
                   << scene.plane.transpose());
      const auto analysis = analyse(request_for(scene.rig, matches, sigma, seed));
      REQUIRE(analysis);
      CHECK(analysis->classification.kind == PairKind::kPlane);
      REQUIRE(analysis->pose);
      REQUIRE(analysis->plane);
      const PoseErrors off = least_errors(*analysis, scene.rig.pose);
      CHECK(off.rotation < rotation);
      CHECK(off.direction < direction);
      decided += !is_undecided(*analysis);
      impossible_others += behind > 0.1;
      if (behind == 0) CHECK(is_undecided(*analysis));
    }
    // Where more than a tenth of the points are behind the cameras, it is decided in nearly all
    // cases.
    INFO(decided << " of " << impossible_others);
    CHECK(impossible_others >= 10);
    CHECK(decided >= 0.9 * impossible_others);
  }
}

TEST_CASE("a few points beside the plane decide between two poses that are both possible (C-102)") {
  int tried = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    // A camera that moves towards a plane has two possible poses, unless noise makes them one.
    FlatScene scene = random_flat_scene(random);
    const double right = uniform(random, -0.15, 0.15);
    const double up = uniform(random, -0.15, 0.15);
    scene.rig.pose.translation = Vector3d(right, up, 0.8);
    constexpr double kSigma = 0.2;
    Matches matches = flat_matches(random, scene, 270, kSigma);
    if (share_behind_in_other(scene, matches) > 0) continue;
    INFO("seed " << seed);
    const auto without = analyse(request_for(scene.rig, matches, kSigma, seed));
    REQUIRE(without);
    REQUIRE(without->plane);
    if (without->plane->evidence == PlaneEvidence::kSame) continue;
    CHECK(is_undecided(*without));
    ++tried;
    for (int i = 0; i < 30; ++i) matches.push_back(random_match(random, scene, kSigma, false));
    const auto with = analyse(request_for(scene.rig, matches, kSigma, seed));
    REQUIRE(with);
    if (with->plane) {
      const auto& [one, other] = with->plane->solutions;
      UNSCOPED_INFO(one.others << " and " << other.others << " others agree; between the poses "
                               << errors_of(one.found.pose, other.found.pose).rotation
                               << " degrees");
    }
    CHECK_FALSE(is_undecided(*with));
    // Where one pose has more of these points than the other, they are no outliers.
    if (with->plane && with->plane->evidence == PlaneEvidence::kOthers)
      CHECK(with->classification.kind == PairKind::kGeneral);
    REQUIRE(with->pose);
    CHECK(errors_of(*with->pose, scene.rig.pose).rotation < 0.5);
  }
  CHECK(tried >= 30);
}

TEST_CASE("a transfer residual is how far a match is from the nearest one, to first order") {
  std::mt19937 random(51);
  for (int i = 0; i < 200; ++i) {
    const FlatScene scene = random_flat_scene(random);
    const Matrix3d homography = homography_of(scene.rig, scene.plane);
    Match match = random_match(random, scene, 0, true);
    CHECK(transfer_residual(homography, match).norm() < 1e-9);
    match.left += test::noise(random, 0.1);
    match.right += test::noise(random, 0.1);
    // The nearest match, by steps of Newton on the left point: it minimises |q - left|^2 + |H q -
    // right|^2.
    Vector2d q = match.left;
    for (int step = 0; step < 30; ++step) {
      const auto moved = [&](const Vector2d& at) {
        return Vector2d((homography * at.homogeneous()).hnormalized());
      };
      constexpr double kStep = 1e-4;
      Eigen::Matrix<double, 4, 2> slope;
      for (int axis = 0; axis < 2; ++axis) {
        const Vector2d by = kStep * Vector2d::Unit(axis);
        slope.col(axis) << Vector2d::Unit(axis), (moved(q + by) - moved(q - by)) / (2 * kStep);
      }
      Vector4d off;
      off << q - match.left, moved(q) - match.right;
      q -= (slope.transpose() * slope).inverse() * slope.transpose() * off;
    }
    const double distance =
        std::hypot((q - match.left).norm(),
                   ((homography * q.homogeneous()).hnormalized() - match.right).norm());
    CHECK(std::abs(transfer_residual(homography, match).norm() - distance) <
          0.01 * distance + 1e-9);
  }
}

}  // namespace glassbox::views
