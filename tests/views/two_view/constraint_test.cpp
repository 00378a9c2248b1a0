// The epipolar constraint (S2-06 to S2-11), in rationals where the statement is exact; and cameras
// from the views of the pipeline.
#include <tests/support/catch.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/view.h>

#include "exact/number.h"
#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/camera.h"
#include "views/two_view/constraint.h"

namespace glassbox::views {
namespace {

using exact::Rational;
using RationalMatrix = std::array<std::array<Rational, 3>, 3>;
using RationalVector = std::array<Rational, 3>;

Rational over(int top, int bottom) {
  return Rational(top) / Rational(bottom);
}

// A rational rotation: Cayley's map of a rational vector.
Matrix3Of<Rational> rational_rotation(const Rational& a, const Rational& b, const Rational& c) {
  const Rational n = Rational(1) + a * a + b * b + c * c, two(2);
  Matrix3Of<Rational> r;
  r << (Rational(1) + a * a - b * b - c * c) / n, two * (a * b - c) / n, two * (a * c + b) / n,
      two * (a * b + c) / n, (Rational(1) - a * a + b * b - c * c) / n, two * (b * c - a) / n,
      two * (a * c - b) / n, two * (b * c + a) / n, (Rational(1) - a * a - b * b + c * c) / n;
  return r;
}

const Matrix3Of<Rational>& rotation() {
  static const Matrix3Of<Rational> r = rational_rotation(over(1, 3), over(-2, 5), over(3, 7));
  return r;
}
const Vector3Of<Rational>& translation() {
  static const Vector3Of<Rational> t(over(3, 2), over(-1, 4), over(2, 3));
  return t;
}

bool is_zero(const auto& matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (!(matrix(i, j) == Rational(0))) return false;
    }
  }
  return true;
}

TEST_CASE("E = R S relates every point's two images, exactly (S2-07 to S2-10)") {
  const Matrix3Of<Rational> e = essential(rotation(), translation());
  const Vector3Of<Rational> left(over(5, 3), over(-7, 2), over(9, 4));
  const Vector3Of<Rational> right = rotation() * (left - translation());
  // Equations (2) to (4) of the slides.
  const Vector3Of<Rational> normal = cross_matrix(translation()) * left;
  CHECK(is_zero((left - translation()).transpose() * normal));
  CHECK(is_zero((rotation().transpose() * right).transpose() * normal));
  CHECK(is_zero(right.transpose() * e * left));
  // The same for projections, with any focal lengths.
  const Vector3Of<Rational> p_left = left * (over(7, 2) / left[2]);
  const Vector3Of<Rational> p_right = right * (over(3, 5) / right[2]);
  CHECK(is_zero(p_right.transpose() * e * p_left));
  CHECK(is_zero(p_right.transpose() * epipolar_line(e, p_left)));
}

TEST_CASE("E's properties, exactly: rank 2, both epipoles, Demazure's identity (S2-09)") {
  const Matrix3Of<Rational> e = essential(rotation(), translation());
  CHECK(is_zero(e * translation()));
  CHECK(is_zero(translation().transpose() * rotation().transpose() * e));
  CHECK(is_zero(demazure(e)));
  // A matrix of rank 2 that is not an essential matrix.
  Matrix3Of<Rational> other = e;
  other.row(0) *= Rational(2);
  CHECK_FALSE(is_zero(demazure(other)));
  // [t]x R with t = -R T is -R S: the order of the factors matters.
  const Vector3Of<Rational> shift = -(rotation() * translation());
  CHECK(is_zero(essential_of_shift(rotation(), shift) + e));
  CHECK_FALSE(is_zero(essential_of_shift(rotation(), translation()) + e));
}

TEST_CASE("the singular values of E are |T|, |T| and 0 (S2-09)") {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const RelativePose pose = test::random_rig(random, 3).pose;
    const Eigen::JacobiSVD<Matrix3d> svd(essential<double>(pose.rotation, pose.translation));
    const double length = pose.translation.norm();
    // Products of numbers up to `length` have errors of a few u of it.
    CHECK(std::abs(svd.singularValues()[0] - length) <= 0x1p-48 * length);
    CHECK(std::abs(svd.singularValues()[1] - length) <= 0x1p-48 * length);
    CHECK(svd.singularValues()[2] <= 0x1p-48 * length);
  }
}

TEST_CASE("epipolar lines are scan lines just where the axes are parallel and B has x alone (E4)") {
  const Matrix3Of<Rational> parallel = Matrix3Of<Rational>::Identity();
  const Vector3Of<Rational> point(over(1, 10), over(1, 5), Rational(1));
  const auto is_scan_line = [&](const Vector3Of<Rational>& baseline) {
    const Vector3Of<Rational> line = epipolar_line(essential(parallel, baseline), point);
    return line[0] == Rational(0) && line[2] + line[1] * point[1] == Rational(0);
  };
  CHECK(is_scan_line({Rational(1), Rational(0), Rational(0)}));
  // B_z = 0 alone is not sufficient: the line is (1/4, -1, 7/40).
  const Vector3Of<Rational> baseline(Rational(1), over(1, 4), Rational(0));
  CHECK_FALSE(is_scan_line(baseline));
  const Vector3Of<Rational> line = epipolar_line(essential(parallel, baseline), point);
  CHECK(line[0] == over(1, 4));
  CHECK(line[1] == Rational(-1));
  CHECK(line[2] == over(7, 40));
}

// The pixel of a point of the scene by the pipeline's matrices.
Vector2d pixel_by_pipeline(const View& view, const Vector3d& p) {
  const Point<World, double> world{p.x(), p.y(), p.z()};
  const auto clip = view.clip_from_eye * (view.eye_from_world * world);
  const auto& v = view.viewport;
  return {double(v.left) + double(v.width()) * (clip.x / clip.w + 1) / 2,
          double(v.top) + double(v.height()) * (1 - clip.y / clip.w) / 2};
}

TEST_CASE("a view's camera projects to the pixels that the pipeline does") {
  std::mt19937 random(2);
  const Camera camera;
  const auto view = make_view(camera, 320, 240);
  REQUIRE(view);
  const auto pinhole = camera_of(*view);
  REQUIRE(pinhole);
  for (int i = 0; i < 100; ++i) {
    const Vector3d world{test::uniform(random, -1, 1), test::uniform(random, -1, 1),
                         -test::uniform(random, 2, 9)};
    const Vector3d pixel = project(*pinhole, world);
    // The pipeline's matrix and these have the same doubles; a few roundings of numbers up to 320
    // differ.
    CHECK((pixel.head<2>() - pixel_by_pipeline(*view, world)).norm() < 1e-10);
    CHECK(std::abs(pixel.z() + world.z()) < 1e-13);
  }
}

}  // namespace
}  // namespace glassbox::views
