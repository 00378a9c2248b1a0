// Rectification, which turns epipolar lines into scan lines.
#include <tests/support/catch.h>

#include <cmath>

#include <Eigen/LU>

#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/rectification.h"

namespace glassbox::views {
namespace {

// Two cameras side by side, both turned a little; the right centre may also be to the left.
StereoRig side_by_side(std::mt19937& random) {
  StereoRig rig = test::random_rig(random, 0.2);
  rig.pose.translation = {test::uniform(random, 0.4, 1), test::uniform(random, -0.2, 0.2),
                          test::uniform(random, -0.2, 0.2)};
  if (test::uniform(random, 0, 1) < 0.5) rig.pose.translation.x() *= -1;
  return rig;
}

TEST_CASE("rectified matches lie on one row, and their distance is f B/Z") {
  std::mt19937 random(40);
  for (int i = 0; i < 50; ++i) {
    const StereoRig rig = side_by_side(random);
    const auto found = rectification_of(rig, 640, 480);
    REQUIRE(found);
    for (int k = 0; k < 20; ++k) {
      const Vector3d point = test::random_point(random, rig);
      const Match match = test::projected_match(point, rig);
      const Vector2d left = (found->left * match.left.homogeneous()).hnormalized();
      const Vector2d right = (found->right * match.right.homogeneous()).hnormalized();
      CHECK(std::abs(left.y() - right.y()) < 1e-9);
      const double depth = found->from_left.row(2).dot(point);
      CHECK(std::abs(left.x() - right.x() - found->intrinsic(0, 0) * found->baseline / depth) <
            1e-9);
    }
    CHECK((found->baseline > 0) == (rig.pose.translation.x() > 0));
  }
}

TEST_CASE("a parallel pair is left as it is, to the byte") {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.translation = {0.3, 0, 0};
  const auto found = rectification_of(rig, 640, 480);
  REQUIRE(found);
  CHECK((found->left - Matrix3d::Identity()).norm() < 1e-12);
  CHECK((found->right - Matrix3d::Identity()).norm() < 1e-12);
  CHECK(found->lost_left == 0);
  CHECK(found->empty_right == 0);
  Image<Rgba8> picture(64, 48);
  std::mt19937 random(41);
  for (Rgba8& pixel : picture.pixels) {
    pixel = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()), 255};
  }
  CHECK(rectified(picture, Matrix3d::Identity()) == picture);
}

TEST_CASE("what a turn loses is counted, and what shows nothing is transparent") {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.rotation = Eigen::AngleAxisd(0.3, Vector3d::UnitY()).matrix();
  rig.pose.translation = {0.5, 0, 0};
  const auto found = rectification_of(rig, 640, 480);
  REQUIRE(found);
  CHECK(found->lost_left > 0.05);
  CHECK(found->empty_left > 0.05);
  const Image<Rgba8> picture(640, 480, Rgba8{10, 20, 30, 255});
  const Image<Rgba8> turned = rectified(picture, found->left);
  std::size_t empty = 0;
  for (const Rgba8& pixel : turned.pixels) {
    empty += pixel.a == 0;
    CHECK((pixel == Rgba8{10, 20, 30, 255} || pixel == Rgba8{0, 0, 0, 0}));
  }
  CHECK(std::abs(double(empty) / (640.0 * 480.0) - found->empty_left) < 1e-12);
}

TEST_CASE("pictures that show each other's place, or are from one, are refused") {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.translation = {0.05, 0, 1};
  CHECK_FALSE(rectification_of(rig, 640, 480));
  rig.pose.translation.setZero();
  CHECK_FALSE(rectification_of(rig, 640, 480));
}

}  // namespace
}  // namespace glassbox::views
