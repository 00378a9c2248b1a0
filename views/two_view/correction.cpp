// Corrects a match: finds the nearest two pixels that fulfil the epipolar constraint.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "views/two_view/polynomial.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {

// Lindstrom's method. `across_right` and `across_left` are the gradients of the constraint with
// respect to the right and the left pixel. One step along both gradients solves the constraint to
// second order, and a second step uses the gradients at the new pixels. Lindstrom's x and x' are
// the right and the left pixel here: x^T F x' = 0.
Match corrected_by_iteration(const Match& pixels, const Matrix3d& fundamental) {
  const Eigen::Matrix2d inner = fundamental.topLeftCorner<2, 2>();
  const Vector3d left = pixels.left.homogeneous(), right = pixels.right.homogeneous();
  Vector2d across_right = (fundamental * left).head<2>();
  Vector2d across_left = (fundamental.transpose() * right).head<2>();
  const double a = across_right.dot(inner * across_left);
  const double b = (across_right.squaredNorm() + across_left.squaredNorm()) / 2;
  const double c = right.dot(fundamental * left);
  if (c == 0 || b == 0) return pixels;
  const double d = std::sqrt(std::max(0.0, b * b - a * c));
  const double step = c / (b + d);
  const Vector2d by_right = step * across_right, by_left = step * across_left;
  across_right -= inner * by_left;
  across_left -= inner.transpose() * by_right;
  const double again = step * 2 * d / (across_right.squaredNorm() + across_left.squaredNorm());
  return {pixels.left - again * across_left, pixels.right - again * across_right};
}

namespace {

// A transform of the picture that moves the point to the origin and turns the epipole onto the x
// axis, to the homogeneous point (1, 0, f).
struct EpipolarFrame {
  Matrix3d from_picture;
  double f = 0;
};

// Whether a homogeneous point is the pixel, to within some roundings of its coordinates.
bool is_at(const Vector3d& point, const Vector2d& pixel) {
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  const Vector3d expected = pixel.homogeneous();
  return point.cross(expected).norm() <= kRounding * point.norm() * expected.norm();
}

EpipolarFrame epipolar_frame(const Vector2d& point, const Vector3d& epipole) {
  Matrix3d moved = Matrix3d::Identity();
  moved.col(2).head<2>() = -point;
  Vector3d at = moved * epipole;
  at /= at.head<2>().norm();
  Matrix3d turned = Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() << at.x(), at.y(), -at.y(), at.x();
  return {turned * moved, at.z()};
}

// The point of the line a x + b y + c = 0 that is nearest to the origin, homogeneous.
Vector3d nearest_to_origin(const Vector3d& line) {
  return {-line.x() * line.z(), -line.y() * line.z(), line.head<2>().squaredNorm()};
}

Eigen::VectorXd product(const Eigen::VectorXd& p, const Eigen::VectorXd& q) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(p.size() + q.size() - 1);
  for (Eigen::Index i = 0; i < p.size(); ++i) result.segment(i, q.size()) += p[i] * q;
  return result;
}

}  // namespace

// Hartley and Sturm's method. The lines through the left epipole are a pencil with parameter t. In
// the frames of both pixels F has the entries a, b, c, d, and the epipoles are at f and f'. The sum
// of the squared distances of the left pixel to a line and of the right pixel to the line's partner
// in the right picture is
//   s(t) = t^2/(1 + (f t)^2) + (c t + d)^2/((a t + b)^2 + f'^2 (c t + d)^2),
// and its derivative is zero at the roots of a polynomial of degree 6. The result is the least of s
// at these roots and for t at infinity.
Match corrected_by_roots(const Match& pixels, const Matrix3d& fundamental) {
  const Eigen::JacobiSVD<Matrix3d> svd(fundamental, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector3d left_epipole = svd.matrixV().col(2), right_epipole = svd.matrixU().col(2);
  if (is_at(left_epipole, pixels.left) || is_at(right_epipole, pixels.right)) return pixels;
  const EpipolarFrame left = epipolar_frame(pixels.left, left_epipole);
  const EpipolarFrame right = epipolar_frame(pixels.right, right_epipole);
  const Matrix3d g =
      right.from_picture.transpose().inverse() * fundamental * left.from_picture.inverse();
  const double a = g(1, 1), b = g(1, 2), c = g(2, 1), d = g(2, 2), f = left.f, h = right.f;
  const auto at_least = [&](double t) {
    const double top = c * t + d, bottom = a * t + b;
    return t * t / (1 + f * f * t * t) + top * top / (bottom * bottom + h * h * top * top);
  };
  const Eigen::Vector2d bottom(b, a), top(d, c), t(0, 1);
  const Eigen::Vector3d spread(1, 0, f * f);  // 1 + f^2 t^2
  const Eigen::VectorXd squares = product(bottom, bottom) + h * h * product(top, top);
  Eigen::VectorXd slope = product(t, product(squares, squares));
  const Eigen::VectorXd other =
      (a * d - b * c) * product(product(spread, spread), product(bottom, top));
  Eigen::VectorXd polynomial = Eigen::VectorXd::Zero(7);
  polynomial.head(slope.size()) += slope;
  polynomial.head(other.size()) -= other;
  const double top_at_infinity = c * c / (a * a + h * h * c * c);
  double best = f != 0 ? 1 / (f * f) + top_at_infinity : std::numeric_limits<double>::infinity();
  Vector3d line_left(f, 0, -1), line_right(-h * c, a, c);
  for (const double root : real_roots(polynomial)) {
    const double value = at_least(root);
    if (!(value < best)) continue;
    best = value;
    line_left = {root * f, 1, -root};
    line_right = {-h * (c * root + d), a * root + b, c * root + d};
  }
  const Vector3d at_left = left.from_picture.inverse() * nearest_to_origin(line_left);
  const Vector3d at_right = right.from_picture.inverse() * nearest_to_origin(line_right);
  return {at_left.hnormalized(), at_right.hnormalized()};
}

}  // namespace glassbox::views
