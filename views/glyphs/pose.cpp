#include "views/glyphs/pose.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>

#include "views/two_view/least_squares.h"
#include "views/two_view/polynomial.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {

namespace {

// ---- three points ----

// Perpendicular axes from three points: the first is along an edge, the third is normal to their
// plane. None for points on a line.
std::optional<Matrix3d> axes_of(const std::array<Vector3d, 3>& p) {
  const Vector3d along = p[1] - p[0], across = along.cross(p[2] - p[0]);
  const double size = along.norm() * (p[2] - p[0]).norm();
  if (!(across.norm() > 1e-12 * size)) return std::nullopt;
  Matrix3d axes;
  axes.col(0) = along.normalized();
  axes.col(2) = across.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

// ---- six points ----

// The transform that moves the centroid to 0 and scales the points to a mean distance of
// sqrt(dimension).
template <int N>
Eigen::Matrix<double, N + 1, N + 1> normaliser(
    const std::vector<Eigen::Matrix<double, N, 1>>& points) {
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  for (const auto& point : points) mean += point / double(points.size());
  double distance = 0;
  for (const auto& point : points) distance += (point - mean).norm() / double(points.size());
  const double scale = distance > 0 ? std::sqrt(double(N)) / distance : 1;
  Eigen::Matrix<double, N + 1, N + 1> matrix = Eigen::Matrix<double, N + 1, N + 1>::Identity();
  matrix.template topLeftCorner<N, N>() *= scale;
  matrix.template topRightCorner<N, 1>() = -scale * mean;
  return matrix;
}

// M = K R, where K is upper triangular with a positive diagonal: the rows of M are made
// perpendicular, the last one first (Gram and Schmidt). M belongs to a camera and so is far from
// singular.
void decompose_projection(const Matrix3d& matrix, Matrix3d& intrinsic, Matrix3d& rotation) {
  intrinsic = Matrix3d::Zero();
  for (int row = 2; row >= 0; --row) {
    Vector3d rest = matrix.row(row).transpose();
    for (int below = row + 1; below < 3; ++below) {
      const Vector3d axis = rotation.row(below).transpose();
      intrinsic(row, below) = rest.dot(axis);
      rest -= intrinsic(row, below) * axis;
    }
    intrinsic(row, row) = rest.norm();
    rotation.row(row) = rest.transpose() / intrinsic(row, row);
  }
  intrinsic /= intrinsic(2, 2);
}

// ---- least squares ----

// Changes a camera by the parameters `by`: a rotation, a translation, and changes of the unknown
// numbers of the lens.
PinholeCamera moved(const PinholeCamera& from, const Eigen::VectorXd& by, KnownIntrinsics known) {
  PinholeCamera camera = from;
  camera.camera_from_world = turned_by(by.head<3>()) * from.camera_from_world;
  camera.centre += by.segment<3>(3);
  if (known != KnownIntrinsics::kAll) {
    camera.intrinsic(0, 0) *= 1 + by[6];
    camera.intrinsic(1, 1) = camera.intrinsic(0, 0);
    camera.intrinsic(0, 1) = 0;
  }
  if (known == KnownIntrinsics::kSquare) {
    camera.intrinsic(0, 2) += by[7] * from.intrinsic(0, 0);
    camera.intrinsic(1, 2) += by[8] * from.intrinsic(0, 0);
  }
  return camera;
}

int unknowns_of(KnownIntrinsics known) {
  return known == KnownIntrinsics::kAll ? 6 : known == KnownIntrinsics::kCentre ? 7 : 9;
}

PinholeCamera refined(const PinholeCamera& from, const std::vector<PointCorrespondence>& points,
                      KnownIntrinsics known) {
  const Eigen::VectorXd by = least_squares(
      unknowns_of(known), 2 * int(points.size()),
      [&](const Eigen::VectorXd& at, Eigen::VectorXd& off) {
        const PinholeCamera camera = moved(from, at, known);
        for (std::size_t i = 0; i < points.size(); ++i)
          off.segment<2>(Eigen::Index(2 * i)) = project_centre(camera, points[i]) - points[i].pixel;
      });
  return by.allFinite() ? moved(from, by, known) : from;
}

double distance_of(const PinholeCamera& camera, const PointCorrespondence& point) {
  if (!(project(camera, point.world).z() > 0)) return INFINITY;
  const double distance = (project_centre(camera, point) - point.pixel).norm();
  return std::isnan(distance) ? INFINITY : distance;
}

// ---- random samples ----

// Replaces entries of K that were estimated from six points by their known values.
PinholeCamera with_known(PinholeCamera camera, const PoseRequest& request) {
  const double focal = std::sqrt(std::abs(camera.intrinsic(0, 0) * camera.intrinsic(1, 1)));
  if (request.known == KnownIntrinsics::kAll) return camera;
  const Vector2d centre = request.known == KnownIntrinsics::kCentre
                              ? Vector2d(request.width / 2.0, request.height / 2.0)
                              : Vector2d(camera.intrinsic(0, 2), camera.intrinsic(1, 2));
  camera.intrinsic << focal, 0, centre.x(), 0, focal, centre.y(), 0, 0, 1;
  return camera;
}

std::vector<PointCorrespondence> selected(const std::vector<PointCorrespondence>& points,
                                          const std::vector<bool>& chosen) {
  std::vector<PointCorrespondence> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (chosen[i]) result.push_back(points[i]);
  }
  return result;
}

class Search {
public:
  Search(const std::vector<PointCorrespondence>& points, const PoseRequest& request)
      : points_(points), request_(request) {}

  std::optional<FoundPose> run() {
    constexpr int kSamples = 300;
    // A camera from six noisy points is rough: its tolerance for agreement with the other points is
    // larger than that of the final camera.
    const double coarse = request_.known == KnownIntrinsics::kAll ? 2 : 8;
    Random random(25);
    const std::size_t size = request_.known == KnownIntrinsics::kAll ? 3 : 6;
    double least = INFINITY;
    for (int i = 0; i < kSamples; ++i) {
      // With an unknown lens, all points are tried first: if none of them is wrong, no sample gives
      // a better camera.
      const bool asks_all = i == 0 && size == 6;
      for (const PinholeCamera& camera : cameras_of(asks_all ? points_ : sample(random, size))) {
        const double cost = cost_of(camera, coarse * request_.threshold);
        if (!(cost < least)) continue;
        least = cost;
        best_ = camera;
      }
    }
    if (!best_) return std::nullopt;
    // Replacing the principal point moves the images of all points, so the camera has to be turned
    // again. For that, use the points that agreed before the change.
    const FoundPose rough = evaluated_pose(*best_, coarse * request_.threshold);
    PinholeCamera camera =
        refined(with_known(*best_, request_), selected(points_, rough.is_inlier), request_.known);
    for (const double limit : {coarse, 2.0, 1.0, 1.0}) {
      const FoundPose pose = evaluated_pose(camera, limit * request_.threshold);
      camera = refined(camera, selected(points_, pose.is_inlier), request_.known);
    }
    return evaluated_pose(camera, request_.threshold);
  }

private:
  std::vector<PointCorrespondence> sample(Random& random, std::size_t size) const {
    std::vector<std::size_t> chosen;
    while (chosen.size() < size) {
      const auto i = std::size_t(random.integer(0, std::int64_t(points_.size()) - 1));
      if (std::ranges::find(chosen, i) == chosen.end()) chosen.push_back(i);
    }
    std::vector<PointCorrespondence> result;
    for (const std::size_t i : chosen) result.push_back(points_[i]);
    return result;
  }
  std::vector<PinholeCamera> cameras_of(const std::vector<PointCorrespondence>& sample) const {
    if (request_.known == KnownIntrinsics::kAll)
      return cameras_from_three_points(request_.intrinsic, {sample[0], sample[1], sample[2]});
    const auto camera = camera_by_dlt(sample);
    if (!camera) return {};
    return {*camera};
  }
  double cost_of(const PinholeCamera& camera, double limit) const {
    double sum = 0;
    for (const PointCorrespondence& point : points_) {
      const double distance = std::min(distance_of(camera, point), limit);
      sum += distance * distance;
    }
    return sum;
  }
  FoundPose evaluated_pose(const PinholeCamera& camera, double limit) const {
    FoundPose pose{camera, {}, 0, 0};
    double squares = 0;
    for (const PointCorrespondence& point : points_) {
      const double distance = distance_of(camera, point);
      pose.is_inlier.push_back(distance <= limit);
      if (distance > limit) continue;
      ++pose.inliers;
      squares += distance * distance;
    }
    pose.rms = pose.inliers > 0 ? std::sqrt(squares / pose.inliers) : 0;
    return pose;
  }

  const std::vector<PointCorrespondence>& points_;
  const PoseRequest& request_;
  std::optional<PinholeCamera> best_;
};

// How flat the points are: the smallest singular value of their differences from the mean, divided
// by the largest. It is 0 for points in a plane.
double flatness(const std::vector<PointCorrespondence>& points) {
  Eigen::MatrixXd rows(Eigen::Index(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.row(Eigen::Index(i)) = points[i].world.transpose();
  rows.rowwise() -= rows.colwise().mean();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows);
  return svd.singularValues()[2] / svd.singularValues()[0];
}

}  // namespace

Vector2d project_centre(const PinholeCamera& camera, const PointCorrespondence& point) {
  if (point.right.isZero() && point.down.isZero()) return project(camera, point.world).head<2>();
  Matrix3d h;
  h << point.right, point.down, point.world - camera.centre;
  h = camera.intrinsic * camera.camera_from_world * h;
  const Vector3d third = h.row(2).transpose().cwiseProduct(Vector3d(1, 1, -1));
  const Vector3d centre = h * third;
  return centre.head<2>() / centre.z();
}

// Improves the distances to three points by two steps of Newton's method, with the laws of cosines
// as equations. A root of the quartic may have lost digits (a double root loses half of them). The
// distances still fulfil the equations, except for an error of the square of the root's error.
static Vector3d agreed(Vector3d distances, const Vector3d& cosines, const Vector3d& squares) {
  for (int step = 0; step < 2; ++step) {
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(3, 3);
    Vector3d excess;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double s = distances[j], t = distances[k], cosine = cosines[i];
      excess[i] = s * s + t * t - 2 * s * t * cosine - squares[i];
      slopes(i, j) = 2 * (s - t * cosine);
      slopes(i, k) = 2 * (t - s * cosine);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes, Eigen::ComputeFullU | Eigen::ComputeFullV);
    distances -= svd.solve(excess);
  }
  return distances;
}

// s1 to s3 are the distances to the points; u = s2/s1, v = s3/s1. Two of the three laws of cosines
// give u as a quotient of polynomials in v, and the third then gives a quartic in v.
std::vector<PinholeCamera> cameras_from_three_points(
    const Matrix3d& intrinsic, const std::array<PointCorrespondence, 3>& points) {
  std::array<Vector3d, 3> world, ray;
  for (std::size_t i = 0; i < 3; ++i) {
    world[i] = points[i].world;
    ray[i] = ray_through(intrinsic, points[i].pixel).normalized();
  }
  const auto world_axes = axes_of(world);
  if (!world_axes) return {};
  const double aa = (world[1] - world[2]).squaredNorm(), bb = (world[0] - world[2]).squaredNorm(),
               cc = (world[0] - world[1]).squaredNorm();
  const double ca = ray[1].dot(ray[2]), cb = ray[0].dot(ray[2]), cg = ray[0].dot(ray[1]);
  const double minus = (aa - cc) / bb, plus = (aa + cc) / bb, c_over_b = cc / bb,
               a_over_b = aa / bb;
  Eigen::VectorXd quartic(5);
  quartic << (1 + minus) * (1 + minus) - 4 * a_over_b * cg * cg,
      4 * (-minus * (1 + minus) * cb + 2 * a_over_b * cg * cg * cb - (1 - plus) * ca * cg),
      2 * (minus * minus - 1 + 2 * minus * minus * cb * cb + 2 * (1 - c_over_b) * ca * ca -
           4 * plus * ca * cb * cg + 2 * (1 - a_over_b) * cg * cg),
      4 * (minus * (1 - minus) * cb - (1 - plus) * ca * cg + 2 * c_over_b * ca * ca * cb),
      (minus - 1) * (minus - 1) - 4 * c_over_b * ca * ca;
  std::vector<PinholeCamera> cameras;
  std::vector<double> symmetric;
  const auto add = [&](double s1, double u, double v) {
    const Vector3d s = agreed(s1 * Vector3d(1, u, v), {ca, cb, cg}, {aa, bb, cc});
    if (!(s.minCoeff() > 0)) return;
    const std::array<Vector3d, 3> seen{s[0] * ray[0], s[1] * ray[1], s[2] * ray[2]};
    const auto seen_axes = axes_of(seen);
    if (!seen_axes) return;
    PinholeCamera camera;
    camera.intrinsic = intrinsic;
    camera.camera_from_world = *seen_axes * world_axes->transpose();
    camera.centre = world[0] - camera.camera_from_world.transpose() * seen[0];
    cameras.push_back(camera);
  };
  for (const double v : real_roots(quartic)) {
    const double s1 = std::sqrt(bb / (1 + v * v - 2 * v * cb));
    if (!(v > 0) || !std::isfinite(s1)) continue;
    const double above = (-1 + minus) * v * v - 2 * minus * cb * v + 1 + minus;
    const double below = 2 * (cg - v * ca);
    // If the three points are seen mirror-symmetric to a plane through the second one, numerator
    // and denominator of u are both 0: the two laws of cosines are the same equation, and u is
    // either of its roots. Such a v is a double root of the quartic, so it appears twice, and only
    // half of its digits are right.
    constexpr double kHalfOfDigits = 0x1p-20;  // 2^-26, with a margin for badly conditioned roots
    if (std::abs(below) < kHalfOfDigits && std::abs(above) < kHalfOfDigits * (1 + v * v)) {
      const double square = cg * cg - 1 + cc / (s1 * s1);
      const bool is_second = std::ranges::any_of(
          symmetric, [&](double other) { return std::abs(other - v) < 4 * kHalfOfDigits * v; });
      symmetric.push_back(v);
      if (is_second || square < 0) continue;
      for (const double u : {cg - std::sqrt(square), cg + std::sqrt(square)})
        if (u > 0) add(s1, u, v);
      continue;
    }
    const double u = above / below;
    if (u > 0 && std::isfinite(u)) add(s1, u, v);
  }
  return cameras;
}

Result<PinholeCamera> camera_by_dlt(const std::vector<PointCorrespondence>& points) {
  if (points.size() < 6)
    return fail("the points", fmt::format("there are {}, but 6 are needed", points.size()),
                "give more points");
  std::vector<Vector3d> world;
  std::vector<Vector2d> pixels;
  for (const PointCorrespondence& point : points) {
    world.push_back(point.world);
    pixels.push_back(point.pixel);
  }
  const Eigen::Matrix4d from_world = normaliser<3>(world);
  const Matrix3d from_pixels = normaliser<2>(pixels);
  Eigen::MatrixXd rows(Eigen::Index(2 * points.size()), 12);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::RowVector4d at = (from_world * world[i].homogeneous()).transpose();
    const Vector3d pixel = from_pixels * pixels[i].homogeneous();
    rows.row(Eigen::Index(2 * i)) << at, Eigen::RowVector4d::Zero(), -pixel.x() * at;
    rows.row(Eigen::Index(2 * i + 1)) << Eigen::RowVector4d::Zero(), at, -pixel.y() * at;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  // The solution is determined up to a scale. Points in one plane leave three more degrees of
  // freedom, and then the last singular value but one is 0, too.
  if (!(svd.singularValues()[10] > 1e-10 * svd.singularValues()[0]))
    return fail("the points", "they are in one plane, from which the lens cannot be computed",
                "give points of two planes, or give the lens");
  const Eigen::Matrix<double, 12, 1> entries = svd.matrixV().col(11);
  const Eigen::Matrix<double, 3, 4> there = entries.reshaped<Eigen::RowMajor>(3, 4);
  Eigen::Matrix<double, 3, 4> projection = from_pixels.inverse() * there * from_world;
  if (projection.leftCols<3>().determinant() < 0) projection = -projection;
  if (!(projection.leftCols<3>().determinant() > 0))
    return fail("the points",
                "no camera could be found that sees the points at these places of the picture",
                "give more points, which are not all in one plane or on one line");
  PinholeCamera camera;
  decompose_projection(projection.leftCols<3>(), camera.intrinsic, camera.camera_from_world);
  camera.centre = -projection.leftCols<3>().inverse() * projection.col(3);
  if (!camera.intrinsic.allFinite() || !camera.centre.allFinite())
    return fail("the points",
                "no camera could be found that sees the points at these places of the picture",
                "give more points, which are not all in one plane or on one line");
  return camera;
}

std::string_view name_of(KnownIntrinsics known) {
  switch (known) {
    case KnownIntrinsics::kAll:
      return "known";
    case KnownIntrinsics::kCentre:
      return "centre";
    case KnownIntrinsics::kSquare:
      return "square";
  }
  return "";
}

Result<FoundPose> find_pose(const std::vector<PointCorrespondence>& points,
                            const PoseRequest& request) {
  const std::size_t least = request.known == KnownIntrinsics::kAll ? 4 : 6;
  if (points.size() < least) {
    return fail("the camera",
                fmt::format("{} glyphs are seen, but {} are needed", points.size(), least),
                "take a picture that shows more glyphs");
  }
  // The least flatness of points that are not taken to be in one plane. Without this limit, noise
  // of a thousandth of the wall's size would be taken for its depth.
  constexpr double kFlat = 0.02;
  if (request.known != KnownIntrinsics::kAll && flatness(points) < kFlat) {
    return fail("the camera",
                "all glyphs that are seen are in one plane, from which the lens cannot be computed",
                "give the lens (--fov), or take a picture of both panels");
  }
  auto pose = Search(points, request).run();
  const std::size_t enough = std::max(least, points.size() / 2);
  if (!pose || std::size_t(pose->inliers) < enough) {
    return fail(
        "the camera",
        fmt::format("only {} of {} glyphs agree with one camera", pose ? pose->inliers : 0,
                    points.size()),
        "check that the wall is the one that the options describe (--grid, --pitch, --first)");
  }
  return *pose;
}

GlyphPoints points_of(const FoundGlyphs& found, const Wall& wall) {
  GlyphPoints result;
  for (std::size_t i = 0; i < found.regions.size(); ++i) {
    const GlyphRegion& region = found.regions[i];
    if (region.broken) continue;
    const WallGlyph* glyph = wall.find(region.identity);
    if (glyph == nullptr) continue;
    const WallPanel& panel = wall.panels[std::size_t(glyph->panel)];
    result.points.push_back({glyph->centre, region.ellipse.centre, wall.radius() * panel.right,
                             wall.radius() * panel.down});
    result.regions.push_back(i);
  }
  return result;
}

PoseError pose_error(const PinholeCamera& camera, const PinholeCamera& truth) {
  return {degrees_from_radians(rotation_error(camera.camera_from_world, truth.camera_from_world)),
          (camera.centre - truth.centre).norm()};
}

}  // namespace glassbox::views
