// S2-05, S2-13: the point of a match against exact arithmetic, its ellipsoid against scattered
// matches, and the names of matches that do not show where their point is.
#include <tests/support/catch.h>

#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "exact/number.h"
#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/constraint.h"
#include "views/two_view/located_point.h"

namespace glassbox::views {
namespace {

using exact::Decimal;
using exact::Rational;
using test::projected_match;
using test::random_point;

constexpr double kUnit = 0x1p-53;

// A pair of different cameras; the baseline is as long as asked for.
StereoRig any_rig(std::mt19937& random, double baseline) {
  StereoRig rig = test::random_rig(random);
  const double focal = test::uniform(random, 300, 3000);
  rig.right_intrinsic << focal, 0, test::uniform(random, 200, 900), 0,
      focal * test::uniform(random, 0.9, 1.1), test::uniform(random, 100, 700), 0, 0, 1;
  rig.pose.translation = baseline * rig.pose.translation.normalized();
  return rig;
}

Matrix3d any_turn(std::mt19937& random) {
  const double angle = test::uniform(random, -3, 3);
  return Eigen::AngleAxisd(angle, test::random_direction(random)).matrix();
}

Match with_noise(Match match, std::mt19937& random, double sigma) {
  match.left += test::noise(random, sigma);
  match.right += test::noise(random, sigma);
  return match;
}

template <class Scalar, class Doubles>
auto in_exact(const Eigen::MatrixBase<Doubles>& m) {
  Eigen::Matrix<Scalar, Doubles::RowsAtCompileTime, Doubles::ColsAtCompileTime> result;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) result(i, j) = Scalar(double(m(i, j)));
  }
  return result;
}
template <class Scalar>
Vector3d in_doubles(const Vector3Of<Scalar>& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}
template <class Scalar>
Scalar exact_dot(const Vector3Of<Scalar>& a, const Vector3Of<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// K^-1 (x, y, 1) for a K without skew.
template <class Scalar>
Vector3Of<Scalar> exact_ray(const Matrix3d& k, const Vector2d& pixel) {
  return {(Scalar(pixel.x()) - Scalar(k(0, 2))) / Scalar(k(0, 0)),
          (Scalar(pixel.y()) - Scalar(k(1, 2))) / Scalar(k(1, 1)), Scalar(1)};
}

// The closest points in rationals, and P half way between them.
struct ExactClosest {
  double along_left = 0, along_right = 0, gap = 0;  // rounded
  Vector3Of<Rational> middle;
};
ExactClosest exact_closest(const Match& pixels, const StereoRig& rig) {
  const auto d = exact_ray<Rational>(rig.left_intrinsic, pixels.left);
  const Vector3Of<Rational> e = in_exact<Rational>(rig.pose.rotation).transpose() *
                                exact_ray<Rational>(rig.right_intrinsic, pixels.right);
  const auto t = in_exact<Rational>(rig.pose.translation);
  const Vector3Of<Rational> across = cross_matrix(d) * e;
  const Rational square = exact_dot(across, across);
  const Rational a = exact_dot<Rational>(cross_matrix(t) * e, across) / square;
  const Rational b = exact_dot<Rational>(cross_matrix(t) * d, across) / square;
  const Vector3Of<Rational> left = d * a, right = t + e * b;
  const auto sign = [](const Rational& x) { return x.sign() < 0 ? -1.0 : 1.0; };
  const Vector3Of<Rational> off = left - right, on_ray = e * b;
  return {sign(a) * std::sqrt(double(exact_dot(left, left))),
          sign(b) * std::sqrt(double(exact_dot(on_ray, on_ray))),
          std::sqrt(double(exact_dot(off, off))), (left + right) / Rational(2)};
}

// How far rounding moves t_l, t_r and P, for u = 2^-53, the angle alpha of the rays and M =
// |T|/sin(alpha). The directions d and e have relative errors of 4 u (one subtraction and one
// division for a coordinate) and 10 u (the same, and R^T). Their cross product n has an error of 18
// u |d| |e|, which is eta = 18 u/sin(alpha) of its length; T x e has 14 u |T| |e|. The multiple
// (T x e) n/n^2 of d therefore has an error of M (14 u + 3 u + 3 eta + 4 u)/|d|, to first order,
// where |T x e|/|n| <= M/|d|. Multiplying by d, adding T, and the mean add 24 u M.
double midpoint_bound(const StereoRig& rig, const Match& pixels) {
  const Rays rays = rays_of(pixels, rig.left_intrinsic, rig.right_intrinsic);
  const Vector3d d = rays.left.normalized();
  const Vector3d e = (rig.pose.rotation.transpose() * rays.right).normalized();
  const double sine = d.cross(e).norm();
  return 1.01 * kUnit * rig.pose.translation.norm() / sine * (45 + 54 / sine);
}

TEST_CASE("t_l, t_r, the gap and the midpoint are those of rationals, within a derived bound") {
  std::mt19937 random(30);
  for (int i = 0; i < 300; ++i) {
    const double baseline = std::pow(10, test::uniform(random, -4, 0));
    const StereoRig rig = any_rig(random, baseline);
    const double sigma = i % 3 == 0 ? 0 : test::uniform(random, 0, 2);
    const Match pixels = with_noise(projected_match(random_point(random, rig), rig), random, sigma);
    const double bound = midpoint_bound(rig, pixels);
    if (!(bound < 1e-3 * baseline)) continue;  // the bound is of first order
    const auto closest =
        closest_points(rays_of(pixels, rig.left_intrinsic, rig.right_intrinsic), rig.pose);
    REQUIRE(closest.has_value());
    const ExactClosest truth = exact_closest(pixels, rig);
    const Vector4d found = triangulate(Triangulator::kMidpoint, pixels, rig).point;
    INFO("trial " << i << ", baseline " << baseline << ", bound " << bound);
    CHECK(std::abs(closest->along_left - truth.along_left) <= bound);
    CHECK(std::abs(closest->along_right - truth.along_right) <= bound);
    CHECK(std::abs(closest->gap - truth.gap) <= 2 * bound);
    const Vector3Of<Rational> off = in_exact<Rational>(found.head<3>()) - truth.middle;
    CHECK(in_doubles(off).norm() <= bound);
  }
}

// A linear system of N equations by Gaussian elimination, in Decimal.
template <int N>
using DecimalMatrix = Eigen::Matrix<Decimal, N, N>;
template <int N>
using DecimalVector = Eigen::Matrix<Decimal, N, 1>;
template <int N>
DecimalVector<N> solved(DecimalMatrix<N> m, DecimalVector<N> right) {
  for (int column = 0; column < N; ++column) {
    int pivot = column;
    for (int row = column; row < N; ++row) {
      if (abs(m(row, column)) > abs(m(pivot, column))) pivot = row;
    }
    m.row(column).swap(m.row(pivot));
    std::swap(right[column], right[pivot]);
    for (int row = column + 1; row < N; ++row) {
      const Decimal factor = m(row, column) / m(column, column);
      for (int k = column; k < N; ++k) m(row, k) -= factor * m(column, k);
      right[row] -= factor * right[column];
    }
  }
  for (int row = N; row-- > 0;) {
    for (int k = row + 1; k < N; ++k) right[row] -= m(row, k) * right[k];
    right[row] /= m(row, row);
  }
  return right;
}

using DecimalProjection = Eigen::Matrix<Decimal, 3, 4>;
DecimalProjection exact_projection(const Matrix3d& intrinsic, const RelativePose& pose) {
  const auto r = in_exact<Decimal>(pose.rotation);
  DecimalProjection pose_matrix;
  pose_matrix << r, -(r * in_exact<Decimal>(pose.translation));
  return in_exact<Decimal>(intrinsic) * pose_matrix;
}

DecimalMatrix<4> exact_equations(const Match& pixels, const StereoRig& rig) {
  const DecimalProjection left = exact_projection(rig.left_intrinsic, {});
  const DecimalProjection right = exact_projection(rig.right_intrinsic, rig.pose);
  DecimalMatrix<4> rows;
  rows << Decimal(pixels.left.x()) * left.row(2) - left.row(0),
      Decimal(pixels.left.y()) * left.row(2) - left.row(1),
      Decimal(pixels.right.x()) * right.row(2) - right.row(0),
      Decimal(pixels.right.y()) * right.row(2) - right.row(1);
  return rows;
}

// The null vector in the least squares sense, by inverse iteration with A^T A. It gains at least
// four digits in two steps if the fourth singular value is below a tenth of the third.
Vector3d exact_linear(const DecimalMatrix<4>& equations) {
  const DecimalMatrix<4> square = equations.transpose() * equations;
  DecimalVector<4> v = DecimalVector<4>::Constant(Decimal(1));
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    v = solved<4>(square, v);
    Decimal largest(0);
    for (const Decimal& x : v) {
      if (abs(x) > largest) largest = abs(x);
    }
    v /= largest;
  }
  return {double(v[0] / v[3]), double(v[1] / v[3]), double(v[2] / v[3])};
}

TEST_CASE("the linear point is that of 50 digits, within the bound of a singular vector") {
  std::mt19937 random(31);
  int tried = 0;
  for (int i = 0; i < 60; ++i) {
    const StereoRig rig = any_rig(random, std::pow(10, test::uniform(random, -2, 0)));
    const double sigma = i % 3 == 0 ? 0 : test::uniform(random, 0, 1);
    const Match pixels = with_noise(projected_match(random_point(random, rig), rig), random, sigma);
    const DecimalMatrix<4> exact = exact_equations(pixels, rig);
    Eigen::Matrix4d equations;
    for (Eigen::Index k = 0; k < 16; ++k) equations(k / 4, k % 4) = double(exact(k / 4, k % 4));
    const Vector4d values = Eigen::JacobiSVD<Eigen::Matrix4d>(equations).singularValues();
    if (!(values[3] < 0.1 * values[2])) continue;
    // The equations have an error of 8 roundings of sums of absolute values, which are below 4 W
    // for the largest number W of pixels and matrices; Jacobi's method adds 256 roundings of their
    // norm (six sweeps of six rotations, six roundings each). By Wedin's theorem the singular
    // vector turns by at most sqrt(2) times this error over the gap of the singular values. The
    // point, its first three numbers divided by the fourth, moves by at most (1 + |P|)^2 of that.
    const double size =
        std::max({rig.left_intrinsic.maxCoeff(), rig.right_intrinsic.maxCoeff(),
                  pixels.left.cwiseAbs().maxCoeff(), pixels.right.cwiseAbs().maxCoeff()});
    const double error = kUnit * (8 * 4 * 4 * size + 256 * equations.norm());
    const Vector3d truth = exact_linear(exact);
    const double bound =
        std::sqrt(2.0) * error / (values[2] - values[3]) * (1 + truth.norm()) * (1 + truth.norm());
    if (!(bound < 1e-3)) continue;
    ++tried;
    INFO("trial " << i << ", bound " << bound);
    CHECK((triangulate_linear(pixels, rig).point.head<3>() - truth).norm() <= bound);
  }
  CHECK(tried > 40);
}

// The sum of squared reprojection errors has its minimum where J^T r = 0. Gauss and Newton's
// iteration in Decimal goes there from the point that was found.
Vector3Of<Decimal> exact_optimum(const Match& pixels, const StereoRig& rig, const Vector3d& start) {
  Vector3Of<Decimal> point = in_exact<Decimal>(start);
  constexpr int kSteps = 25;
  for (int step = 0; step < kSteps; ++step) {
    DecimalMatrix<3> normal = DecimalMatrix<3>::Constant(Decimal(0));
    DecimalVector<3> right = DecimalVector<3>::Constant(Decimal(0));
    const auto add_picture = [&](const Matrix3d& k, const RelativePose& pose,
                                 const Vector2d& pixel) {
      const auto rotation = in_exact<Decimal>(pose.rotation);
      const Vector3Of<Decimal> at =
          in_exact<Decimal>(k) * (rotation * (point - in_exact<Decimal>(pose.translation)));
      const Matrix3Of<Decimal> slopes = in_exact<Decimal>(k) * rotation;
      for (int i = 0; i < 2; ++i) {
        const Decimal residual = at[i] / at[2] - Decimal(pixel[i]);
        Vector3Of<Decimal> row;
        for (int j = 0; j < 3; ++j) row[j] = (slopes(i, j) - at[i] / at[2] * slopes(2, j)) / at[2];
        for (int a = 0; a < 3; ++a) {
          right[a] -= row[a] * residual;
          for (int b = 0; b < 3; ++b) normal(a, b) += row[a] * row[b];
        }
      }
    };
    add_picture(rig.left_intrinsic, {}, pixels.left);
    add_picture(rig.right_intrinsic, rig.pose, pixels.right);
    const DecimalVector<3> move = solved<3>(normal, right);
    point += move;
  }
  return point;
}

TEST_CASE("the optimal point is that of 50 digits, within the error of the epipoles") {
  std::mt19937 random(32);
  int tried = 0;
  for (int i = 0; i < 60; ++i) {
    const StereoRig rig = any_rig(random, std::pow(10, test::uniform(random, -1, 0)));
    const double sigma = i % 3 == 0 ? 0 : test::uniform(random, 0, 1);
    const Match pixels = with_noise(projected_match(random_point(random, rig), rig), random, sigma);
    const Vector4d found = triangulate(Triangulator::kHartleySturm, pixels, rig).point;
    if (found.w() == 0) continue;
    // Let W be the size of pixel coordinates. In units of W, the products of F and Jacobi's method
    // leave F and the epipoles off by 128 roundings of F over its second singular value. Lines
    // through the pixels are then off by W times that, and so are the corrected pixels. The point
    // is off by so many pixels times the longest half axis of its ellipsoid for 1 px, in four
    // coordinates (a factor of 2), and by the error of the midpoint.
    const double size =
        std::max(pixels.left.homogeneous().norm(), pixels.right.homogeneous().norm());
    const Vector3d units(size, size, 1);
    const Matrix3d scaled = units.asDiagonal() * fundamental_of(rig) * units.asDiagonal();
    const Vector3d values = Eigen::JacobiSVD<Matrix3d>(scaled).singularValues();
    const double off = 128 * kUnit * values[0] / values[1] * size;
    const ErrorEllipsoid ellipsoid =
        error_ellipsoid(Triangulator::kHartleySturm, found.head<3>(), rig, 1);
    const double bound = 2 * off * ellipsoid.half_axes.x() + midpoint_bound(rig, pixels);
    // Gauss and Newton's iteration converges if the error of the point is small.
    if (!(sigma * ellipsoid.half_axes.x() < 0.01 * found.head<3>().norm())) continue;
    ++tried;
    const Vector3Of<Decimal> truth = exact_optimum(pixels, rig, found.head<3>());
    const Vector3Of<Decimal> difference = in_exact<Decimal>(found.head<3>()) - truth;
    INFO("trial " << i << ", bound " << bound << ", off by " << in_doubles(difference).norm());
    CHECK(in_doubles(difference).norm() <= bound);
  }
  CHECK(tried > 30);
}

// The covariance of the points of noisy matches, in the frame of the ellipsoid, with each axis
// divided by its half axis: the identity if the ellipsoid is right.
Matrix3d whitened_scatter(Triangulator how, const StereoRig& rig, const Vector3d& point,
                          const ErrorEllipsoid& ellipsoid, double sigma, int samples,
                          std::mt19937& random) {
  const Match exact = projected_match(point, rig);
  std::vector<Vector3d> offs;
  Vector3d mean = Vector3d::Zero();
  for (int i = 0; i < samples; ++i) {
    const Vector4d found = triangulate(how, with_noise(exact, random, sigma), rig).point;
    offs.emplace_back((ellipsoid.axes.transpose() * (found.head<3>() - point)).array() /
                      ellipsoid.half_axes.array());
    mean += offs.back() / samples;
  }
  Matrix3d scatter = Matrix3d::Zero();
  for (const Vector3d& off : offs)
    scatter += (off - mean) * (off - mean).transpose() / (samples - 1);
  return scatter;
}

// Cameras that see a point at distance 6; the right one is as near as asked for, and is turned
// around the point, which it looks at.
StereoRig converging_rig(double degrees, double away) {
  constexpr double kDegree = 0.017453292519943295;
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  const double sine = std::sin(degrees * kDegree), cosine = std::cos(degrees * kDegree);
  rig.pose.translation = {away * sine, 0, 6 - away * cosine};
  rig.pose.rotation << cosine, 0, sine, 0, 1, 0, -sine, 0, cosine;
  return rig;
}

TEST_CASE("the ellipsoid of each method is the scatter of 10,000 noisy matches (S2-13)") {
  std::mt19937 random(33);
  constexpr int kSamples = 10'000;
  constexpr double kSigma = 0.2;
  const Vector3d point(0, 0, 6);
  for (const auto& [degrees, away] : {std::pair{10.0, 6.0}, {60.0, 1.0}, {25.0, 2.0}}) {
    const StereoRig rig = converging_rig(degrees, away);
    for (const Triangulator how : kTriangulators) {
      const ErrorEllipsoid ellipsoid = error_ellipsoid(how, point, rig, kSigma);
      const Matrix3d scatter =
          whitened_scatter(how, rig, point, ellipsoid, kSigma, kSamples, random);
      INFO(name_of(how) << " at " << degrees << " deg\n" << scatter);
      // The variance of N samples has a deviation of sqrt(2/N) of its value, a covariance one of
      // sqrt(1/N) of both deviations: five of them are allowed.
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          const double expected = row == column ? 1 : 0;
          const double deviation = std::sqrt((row == column ? 2.0 : 1.0) / kSamples);
          CHECK(std::abs(scatter(row, column) - expected) < 5 * deviation);
        }
      }
    }
  }
}

TEST_CASE("the ellipsoid of the optimum is (J^T J)^-1, and no other method's is smaller") {
  std::mt19937 random(34);
  for (int i = 0; i < 100; ++i) {
    const StereoRig rig = any_rig(random, test::uniform(random, 0.2, 2));
    const Vector3d point = random_point(random, rig);
    const Matrix3d best = covariance_of(point, rig, 0.5);
    const Matrix3d found =
        error_ellipsoid(Triangulator::kHartleySturm, point, rig, 0.5).covariance();
    INFO("trial " << i);
    CHECK((found - best).norm() < 1e-8 * best.norm());
    for (const Triangulator how : kTriangulators) {
      const ErrorEllipsoid other = error_ellipsoid(how, point, rig, 0.5);
      const Eigen::SelfAdjointEigenSolver<Matrix3d> excess(other.covariance() - best);
      CHECK(excess.eigenvalues().minCoeff() > -1e-8 * best.norm());
      CHECK((other.axes.transpose() * other.axes - Matrix3d::Identity()).norm() < 1e-14);
      CHECK(other.half_axes.x() >= other.half_axes.y());
      CHECK(other.half_axes.y() >= other.half_axes.z());
    }
  }
  // One camera six times nearer: the midpoint gives both rays the same weight.
  const StereoRig rig = converging_rig(60, 1);
  const Vector3d point(0, 0, 6);
  CHECK(error_ellipsoid(Triangulator::kMidpoint, point, rig, 1).half_axes.norm() >
        1.07 * error_ellipsoid(Triangulator::kHartleySturm, point, rig, 1).half_axes.norm());
}

std::array<PinholeCamera, 2> cameras_of(const StereoRig& rig) {
  return {PinholeCamera{rig.left_intrinsic, Matrix3d::Identity(), Vector3d::Zero()},
          PinholeCamera{rig.right_intrinsic, rig.pose.rotation, rig.pose.translation}};
}

// Eyes side by side, 0.1 apart.
StereoRig parallel_rig() {
  StereoRig rig;
  rig.left_intrinsic = rig.right_intrinsic = test::sample_intrinsic();
  rig.pose.translation = {0.1, 0, 0};
  return rig;
}

TEST_CASE("a match whose point is nowhere to be seen is named (C-107)") {
  const auto cameras = cameras_of(parallel_rig());
  StereoRig forward = parallel_rig();
  forward.pose.translation = {0, 0, 1};
  StereoRig back_to_back = parallel_rig();
  back_to_back.pose.rotation.diagonal() << -1, 1, -1;
  for (const Triangulator how : kTriangulators) {
    INFO(name_of(how));
    const auto state = [&](const Match& match, const auto& pair) {
      return locate(how, match, pair, 0.1).state;
    };
    CHECK(state({{400, 100}, {380, 100}}, cameras) == PointState::kInFront);
    CHECK(state({{380, 100}, {400, 100}}, cameras) == PointState::kBehindBoth);
    CHECK(state({{400, 100}, {400, 100}}, cameras) == PointState::kAtInfinity);
    const Vector4d far_away = locate(how, {{400, 100}, {400, 100}}, cameras, 0.1).point;
    CHECK((far_away - Vector4d(0.1, -0.175, 1, 0)).norm() < 1e-15);
    CHECK(state({{400, 100}, {399.7, 100}}, cameras) == PointState::kNearlyParallel);
    CHECK(state({{400.3, 100}, {400.7, 100}}, cameras) == PointState::kNearlyParallel);
    // Both pixels are the image of the other camera.
    CHECK(state({{320, 240}, {320, 240}}, cameras_of(forward)) == PointState::kOnBaseline);
    // One is: the point is the other camera's centre.
    CHECK(state({{320, 240}, {350, 260}}, cameras_of(forward)) == PointState::kOnBaseline);
    // The camera between the point and its image looks away.
    const StereoRig rig = back_to_back;
    const Match behind_right = projected_match({0.2, 0.1, 5}, rig);
    CHECK(state(behind_right, cameras_of(rig)) == PointState::kBehindRight);
    const Match behind_left = projected_match({0.2, 0.1, -5}, rig);
    CHECK(state(behind_left, cameras_of(rig)) == PointState::kBehindLeft);
  }
}

TEST_CASE("a match with a pixel at the epipole is not moved, and is no NaN") {
  // Both cameras look along the baseline, so the epipoles are at (0, 0).
  Matrix3d forward;
  forward << 0, -1, 0, 1, 0, 0, 0, 0, 0;
  for (const Match& match : {Match{{0, 0}, {0.1, 0.2}}, Match{{0.3, 0.1}, {0, 0}}}) {
    for (const Match& moved :
         {corrected_by_roots(match, forward), corrected_by_iteration(match, forward)}) {
      CHECK(moved.left == match.left);
      CHECK(moved.right == match.right);
    }
  }
}

TEST_CASE("rays of points at infinity are named nearly parallel, and those of near points never") {
  std::mt19937 random(35);
  constexpr int kCount = 2000;
  constexpr double kSigma = 0.5;
  int far_named = 0, not_in_front = 0;
  for (int i = 0; i < kCount; ++i) {
    const StereoRig rig = any_rig(random, 0.3);
    const auto state = [&](double distance) {
      const Match match = projected_match(random_point(random, rig, distance, distance), rig);
      return locate(Triangulator::kMidpoint, with_noise(match, random, kSigma), cameras_of(rig),
                    kSigma)
          .state;
    };
    far_named += state(1e9) == PointState::kNearlyParallel;
  }
  // The angle of rays to infinity is the length of two normal numbers with nearly one deviation:
  // above three of them with the probability exp(-4.5) = 0.011, and less if one is smaller.
  CHECK(far_named > kCount * 97 / 100);
  const StereoRig rig = parallel_rig();
  for (int i = 0; i < kCount; ++i) {
    // At distance 1 the disparity is 80 px, a hundred deviations.
    const Match match = with_noise(projected_match({0.05, 0, 1}, rig), random, kSigma);
    not_in_front += locate(Triangulator::kMidpoint, match, cameras_of(rig), kSigma).state !=
                    PointState::kInFront;
  }
  CHECK(not_in_front == 0);
}

TEST_CASE("world rays meet the world point, whatever the cameras' places") {
  std::mt19937 random(36);
  for (int i = 0; i < 100; ++i) {
    const StereoRig rig = any_rig(random, test::uniform(random, 0.2, 2));
    std::array<PinholeCamera, 2> cameras = cameras_of(rig);
    const Matrix3d turn = any_turn(random);
    const Vector3d shift = 10 * test::random_direction(random);
    for (PinholeCamera& camera : cameras) {
      camera.camera_from_world = camera.camera_from_world * turn;
      camera.centre = turn.transpose() * camera.centre + shift;
    }
    const Vector3d own = random_point(random, rig, 2, 5);
    const Vector3d world = turn.transpose() * own + shift;
    const LocatedPoint located =
        locate(Triangulator::kMidpoint, projected_match(own, rig), cameras, 0.01);
    INFO("trial " << i << " " << name_of(located.state));
    if (located.state != PointState::kInFront) continue;
    CHECK((located.point.head<3>() - world).norm() < 1e-9);
    CHECK(located.residual() < 1e-8);
    for (std::size_t k = 0; k < 2; ++k) {
      const WorldRay& ray = located.rays[k];
      const double along = k == 0 ? located.closest->along_left : located.closest->along_right;
      CHECK((ray.origin + along * ray.direction - world).norm() < 1e-9);
      CHECK((ray.origin - cameras[k].centre).norm() == 0);
    }
    // The longest axis is along the ray of a far point; it does not depend on the frame.
    const ErrorEllipsoid in_left = error_ellipsoid(Triangulator::kMidpoint, own, rig, 0.01);
    CHECK((located.ellipsoid->half_axes - in_left.half_axes).norm() <
          1e-6 * in_left.half_axes.norm());
  }
}

TEST_CASE("cameras that only turn are in one place, and a short baseline is a baseline") {
  std::mt19937 random(37);
  for (int i = 0; i < 100; ++i) {
    const Vector3d place = 100 * test::random_direction(random);
    std::array<PinholeCamera, 2> cameras;
    for (PinholeCamera& camera : cameras) {
      camera.camera_from_world = any_turn(random);
      // As a file has it: t = -R c, and the centre is computed from t.
      const Vector3d shift = -camera.camera_from_world * place;
      camera.centre = -camera.camera_from_world.transpose() * shift;
    }
    INFO("trial " << i);
    CHECK(are_in_one_place(cameras));
    cameras[1].centre += 1e-9 * test::random_direction(random);
    CHECK_FALSE(are_in_one_place(cameras));
  }
}

}  // namespace
}  // namespace glassbox::views
