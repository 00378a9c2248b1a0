// The camera from glyphs: from three points, from six, and by least squares from all.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>

#include "views/glyphs/pose.h"
#include "views/glyphs/sweep.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {
namespace {

PointCorrespondence disc_of(const Wall& wall, std::size_t glyph) {
  const WallGlyph& one = wall.glyphs[glyph % wall.glyphs.size()];
  const WallPanel& panel = wall.panels[std::size_t(one.panel)];
  return {one.centre, {}, wall.radius() * panel.right, wall.radius() * panel.down};
}

// Every `step`th glyph, at the place where the camera sees it.
std::vector<PointCorrespondence> points_seen(const Wall& wall, const PinholeCamera& camera,
                                             std::size_t count, std::size_t step) {
  std::vector<PointCorrespondence> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(disc_of(wall, i * step));
    points.back().pixel = project_centre(camera, points.back());
  }
  return points;
}

// The centre of the conic through eight points, from the conic's six coefficients.
Vector2d centre_of_conic(const std::array<Vector2d, 8>& border) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& point : border) mean += point / 8;
  const double scale = 1 / (border[0] - mean).norm();
  Eigen::Matrix<double, 8, 6> rows;
  for (int i = 0; i < 8; ++i) {
    const Vector2d p = scale * (border[std::size_t(i)] - mean);
    rows.row(i) << p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.x(), p.y(), 1;
  }
  const Eigen::JacobiSVD<Eigen::Matrix<double, 8, 6>> svd(rows, Eigen::ComputeFullV);
  const Eigen::Matrix<double, 6, 1> c = svd.matrixV().col(5);
  Eigen::Matrix2d twice;
  twice << 2 * c[0], c[1], c[1], 2 * c[2];
  const Vector2d centre = -twice.inverse() * Vector2d(c[3], c[4]);
  return mean + centre / scale;
}

// A camera that differs by a step of the unknowns: a rotation, a translation, and the unknown
// numbers of the lens.
PinholeCamera stepped(const PinholeCamera& from, const Eigen::VectorXd& by) {
  PinholeCamera camera = from;
  camera.camera_from_world = turned_by(by.head<3>()) * from.camera_from_world;
  camera.centre += by.segment<3>(3);
  if (by.size() > 6) camera.intrinsic(0, 0) = camera.intrinsic(1, 1) += by[6];
  if (by.size() > 7) camera.intrinsic.block<2, 1>(0, 2) += by.segment<2>(7);
  return camera;
}

// The expected squared distance of the best possible estimate of the camera's centre, for noise of
// this deviation in each coordinate: the centre's part of sigma^2 (J^T J)^-1 (Gauss and Markov).
double expected_square(const PinholeCamera& camera, const std::vector<PointCorrespondence>& points,
                       int unknowns, double deviation) {
  Eigen::MatrixXd j(Eigen::Index(2 * points.size()), unknowns);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < unknowns; ++k) {
    const Eigen::VectorXd by = kStep * Eigen::VectorXd::Unit(unknowns, k);
    const PinholeCamera more = stepped(camera, by), less = stepped(camera, -by);
    for (std::size_t i = 0; i < points.size(); ++i) {
      j.block<2, 1>(Eigen::Index(2 * i), k) =
          (project_centre(more, points[i]) - project_centre(less, points[i])) / (2 * kStep);
    }
  }
  const Eigen::MatrixXd covariance = deviation * deviation * (j.transpose() * j).inverse();
  return covariance.block<3, 3>(3, 3).trace();
}

double gaussian(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

}  // namespace

TEST_CASE("the centre of a disc's picture is that of the ellipse through its border") {
  const Wall wall = *make_wall({});
  Random random(31);
  double apart = 0;
  for (int i = 0; i < 100; ++i) {
    const double distance = random.between(0.8, 3);
    const double aside = random.between(-40, 40), above = random.between(-30, 30);
    const PinholeCamera camera = camera_in_front(distance, aside, above, 640, 480);
    const PointCorrespondence disc = disc_of(wall, std::size_t(random.integer(0, kGlyphs - 1)));
    std::array<Vector2d, 8> border;
    for (int k = 0; k < 8; ++k) {
      const SinCos turn = sin_cos_degrees(45.0 * k);
      border[std::size_t(k)] =
          project(camera, disc.world + turn.cos * disc.right + turn.sin * disc.down).head<2>();
    }
    const Vector2d seen = project_centre(camera, disc);
    // Coefficients of order 1 with a few roundings each, for an ellipse of at most 200 px.
    CHECK((seen - centre_of_conic(border)).norm() < 1e-9);
    apart = std::max(apart, (seen - project(camera, disc.world).head<2>()).norm());
  }
  // The centre of the ellipse is not the picture of the disc's centre.
  CHECK(apart > 0.2);
}

TEST_CASE("three points have up to four cameras, each of which sees them, one of which is right") {
  Random random(3);
  const Wall wall = *make_wall({});
  std::array<int, 5> counts{};
  int runs = 0;
  for (int i = 0; i < 500; ++i) {
    const double distance = random.between(1, 4);
    const double aside = random.between(-30, 30), above = random.between(-40, 40);
    const PinholeCamera camera = camera_in_front(distance, aside, above, 640, 480);
    std::array<PointCorrespondence, 3> points;
    for (PointCorrespondence& point : points) {
      point.world = wall.glyphs[std::size_t(random.integer(0, kGlyphs - 1))].centre;
      point.pixel = project(camera, point.world).head<2>();
    }
    const double area =
        (points[1].world - points[0].world).cross(points[2].world - points[0].world).norm();
    if (area < 0.02) continue;
    const auto cameras = cameras_from_three_points(camera.intrinsic, points);
    INFO("run " << i << ", area " << area);
    REQUIRE(cameras.size() <= 4);
    ++counts[cameras.size()];
    ++runs;
    double least = INFINITY;
    for (const PinholeCamera& one : cameras) {
      least = std::min(least, pose_error(one, camera).distance);
      CHECK((one.camera_from_world * one.camera_from_world.transpose() - Matrix3d::Identity())
                .norm() < 1e-14);
      for (const PointCorrespondence& point : points) {
        const Vector3d seen = project(one, point.world);
        CHECK(seen.z() > 0);
        // Roots have a relative error of up to 3e-6, and a double root half the digits. After two
        // steps of Newton's method the roundings of 800 px are left, 1e-13, multiplied by the shape
        // of the thinnest triangle: a side of a metre over its height of 2 cm, squared.
        CHECK((seen.head<2>() - point.pixel).norm() < 1e-9);
      }
    }
    CHECK(least < 1e-8);
  }
  CHECK(runs > 400);
  CHECK(counts[0] == 0);
  CHECK(counts[4] > 0);
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  CHECK(cameras_from_three_points(Matrix3d::Identity(),
                                  {PointCorrespondence{a, {0, 0}}, {b, {1, 0}}, {c, {2, 0}}})
            .empty());
}

TEST_CASE("three points that are seen as mirrored have their camera among those found") {
  PinholeCamera camera;
  camera.intrinsic << 800, 0, 320, 0, 800, 240, 0, 0, 1;
  for (const double height : {0.25, -0.5, 0.5}) {
    // Symmetric about x = 0, the plane of the camera and its gaze, and not on the cylinder through
    // the three points, where roots coincide further.
    camera.camera_from_world = turned_by({radians_from_degrees(10), 0, 0});
    camera.centre = {0, 0.1, -2};
    std::array<PointCorrespondence, 3> points{PointCorrespondence{{-0.5, 0, 0}, {}},
                                              PointCorrespondence{{0, height, 0}, {}},
                                              PointCorrespondence{{0.5, 0, 0}, {}}};
    for (PointCorrespondence& point : points) point.pixel = project(camera, point.world).head<2>();
    for (int turn = 0; turn < 3; ++turn) {
      INFO("height " << height << ", turn " << turn);
      const auto cameras = cameras_from_three_points(camera.intrinsic, points);
      REQUIRE(cameras.size() <= 4);
      double least = INFINITY;
      for (const PinholeCamera& one : cameras) {
        least = std::min(least, pose_error(one, camera).distance);
        for (const PointCorrespondence& point : points)
          CHECK((project(one, point.world).head<2>() - point.pixel).norm() < 1e-3);
      }
      CHECK(least < 1e-5);
      std::rotate(points.begin(), points.begin() + 1, points.end());
    }
  }
}

TEST_CASE("six points of two planes decide the camera and its lens, six of one plane do not") {
  const Wall wall = *make_wall({});
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    const double aside = random.between(-30, 30), above = random.between(-20, 20);
    PinholeCamera camera = camera_in_front(2, aside, above, 640, 480);
    camera.intrinsic << 700, 3, 300, 0, 680, 250, 0, 0, 1;
    std::vector<PointCorrespondence> points = points_seen(wall, camera, 12, 37);
    for (PointCorrespondence& point : points) point.pixel = project(camera, point.world).head<2>();
    const auto found = camera_by_dlt(points);
    REQUIRE(found);
    // After normalization the condition of the system is below 10^4: twelve of sixteen digits are
    // left.
    CHECK((found->intrinsic - camera.intrinsic).norm() < 1e-9 * camera.intrinsic.norm());
    CHECK(pose_error(*found, camera).distance < 1e-9);
    CHECK(pose_error(*found, camera).degrees < 1e-7);
    std::erase_if(points, [](const PointCorrespondence& point) { return point.world.x() > 0; });
    REQUIRE(points.size() == 7);
    const auto flat = camera_by_dlt(points);
    REQUIRE_FALSE(flat);
    CHECK(flat.error().message().find("in one plane") != std::string::npos);
  }
}

TEST_CASE("a camera from points with noise is as near as the best estimate can be") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_in_front(2, 10, 5, 640, 480);
  const std::vector<PointCorrespondence> exact = points_seen(wall, camera, 60, 7);
  constexpr double kDeviation = 0.2;  // px
  for (const auto& [known, unknowns] :
       {std::pair(KnownIntrinsics::kAll, 6), std::pair(KnownIntrinsics::kCentre, 7),
        std::pair(KnownIntrinsics::kSquare, 9)}) {
    const double expected = expected_square(camera, exact, unknowns, kDeviation);
    Random random(41);
    constexpr int kRuns = 24;
    double squares = 0, residuals = 0;
    for (int run = 0; run < kRuns; ++run) {
      std::vector<PointCorrespondence> points = exact;
      for (PointCorrespondence& point : points)
        point.pixel += kDeviation * Vector2d{gaussian(random), gaussian(random)};
      const auto pose = find_pose(points, {known, camera.intrinsic, 640, 480, 2});
      REQUIRE(pose);
      // 2 px are ten deviations, so no point is left out.
      CHECK(pose->inliers == 60);
      const double off = pose_error(pose->camera, camera).distance;
      squares += off * off / kRuns;
      residuals += pose->rms * pose->rms / kRuns;
    }
    INFO(name_of(known) << ": " << squares << " of " << expected);
    // Most of the error is along one direction, so the mean of 24 squares has a relative deviation
    // of sqrt(2 / 24) = 0.29; three deviations to either side.
    CHECK(squares > 0.13 * expected);
    CHECK(squares < 1.87 * expected);
    // 120 coordinates minus the unknowns, times the variance, over 60 points. In 24 runs of 111 to
    // 114 squares one deviation is 0.027 of it.
    CHECK(residuals == Approx((120 - unknowns) * kDeviation * kDeviation / 60).epsilon(3 * 0.027));
  }
}

TEST_CASE("wrong glyphs are found out by those that agree, as long as these are the most") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_in_front(1.2, 30, 10, 800, 600);
  const std::vector<PointCorrespondence> right = points_seen(wall, camera, 40, 3);
  const auto with_wrong = [&](std::size_t count) {
    std::vector<PointCorrespondence> points = right;
    for (std::size_t i = 0; i < count; ++i)
      points[i].pixel += Vector2d(30 + 7 * double(i * i % 11), -25 - 9 * double(i * i % 7));
    return points;
  };
  for (const KnownIntrinsics known :
       {KnownIntrinsics::kAll, KnownIntrinsics::kCentre, KnownIntrinsics::kSquare}) {
    const PoseRequest request{known, camera.intrinsic, 800, 600, 2};
    const auto pose = find_pose(with_wrong(12), request);
    INFO(name_of(known));
    REQUIRE(pose);
    CHECK(pose->inliers == 28);
    for (std::size_t i = 0; i < 40; ++i) CHECK(pose->is_inlier[i] == (i >= 12));
    CHECK(pose_error(pose->camera, camera).distance < 1e-6);
  }
  // 17 of 40 are less than half.
  const auto refused =
      find_pose(with_wrong(23), {KnownIntrinsics::kAll, camera.intrinsic, 800, 600, 2});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message().find("17 of 40 glyphs agree") != std::string::npos);
}

TEST_CASE("cameras that too few glyphs, one plane or disagreement leave open are refused") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_in_front(2, 0, 0, 640, 480);
  const auto refusal = [](const auto& pose) {
    REQUIRE_FALSE(pose);
    return pose.error().message();
  };
  const PoseRequest known{KnownIntrinsics::kAll, camera.intrinsic, 640, 480, 2},
      open{KnownIntrinsics::kCentre, {}, 640, 480, 2};
  CHECK(refusal(find_pose(points_seen(wall, camera, 3, 7), known)).find("3 glyphs are seen") !=
        std::string::npos);
  CHECK(find_pose(points_seen(wall, camera, 4, 17), known));
  CHECK(refusal(find_pose(points_seen(wall, camera, 5, 17), open)).find("5 glyphs are seen") !=
        std::string::npos);
  auto flat = points_seen(wall, camera, 60, 1);
  CHECK(refusal(find_pose(flat, open)).find("in one plane") != std::string::npos);
  CHECK(find_pose(flat, known));
  Random random(9);
  for (PointCorrespondence& point : flat)
    point.pixel = {random.between(0, 640), random.between(0, 480)};
  CHECK(refusal(find_pose(flat, known)).find("of 60 glyphs agree") != std::string::npos);
}

TEST_CASE("the error of a camera is its turn in degrees and the distance of its place") {
  const PinholeCamera truth = camera_in_front(2, 20, 10, 640, 480);
  for (const double degrees : {1e-6, 0.05, 30.0, 179.0}) {
    PinholeCamera camera = truth;
    camera.camera_from_world =
        turned_by(radians_from_degrees(degrees) * Vector3d(1, -2, 2) / 3) * truth.camera_from_world;
    camera.centre += Vector3d(0.001, -0.002, 0.002);
    CHECK(pose_error(camera, truth).degrees == Approx(degrees).epsilon(1e-9));
    CHECK(pose_error(camera, truth).distance == Approx(0.003));
  }
}

}  // namespace glassbox::views
