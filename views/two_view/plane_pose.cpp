#include "views/two_view/plane_pose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "views/two_view/estimate.h"
#include "views/two_view/refinement.h"
#include "views/two_view/residual.h"

namespace glassbox::views {

namespace {

// The homography of calibrated points, scaled so that it is R (I - T m^T): the second singular
// value is 1, and a point in front of the left camera is in front of the right one.
Matrix3d scaled(const Matrix3d& homography, double second, const Matches& calibrated) {
  const auto front = std::ranges::count_if(calibrated, [&](const Match& match) {
    return match.right.homogeneous().dot(homography * match.left.homogeneous()) > 0;
  });
  return homography / (2 * std::size_t(front) < calibrated.size() ? -second : second);
}

PlanePose facing(const Matrix3d& rotation, const Vector3d& normal, const Vector3d& shift,
                 const Matches& calibrated) {
  const auto front = std::ranges::count_if(
      calibrated, [&](const Match& match) { return normal.dot(match.left.homogeneous()) > 0; });
  const double sign = 2 * std::size_t(front) < calibrated.size() ? -1 : 1;
  return {{rotation, sign * shift.normalized()}, sign * shift.norm() * normal};
}

}  // namespace

Matrix3d homography_of(const StereoRig& rig, const Vector3d& plane) {
  const auto& [rotation, translation] = rig.pose;
  return rig.right_intrinsic * rotation * (Matrix3d::Identity() - translation * plane.transpose()) *
         rig.left_intrinsic.inverse();
}

// H = R (I - T m^T) turns the vectors across m as R does, so it keeps their lengths. With the
// singular values s1 >= 1 >= s3 of H and the right singular vectors v1, v2, v3, it keeps the
// lengths in two planes, which v2 spans with each of the vectors u = sqrt(1 - s3^2) v1 +-
// sqrt(s1^2 - 1) v3. In such a plane R is H, and the third axis follows. With the unit normal n of
// the plane, T |m| = n - R^T H n.
std::optional<std::array<PlanePose, 2>> poses_of_homography(const Matrix3d& homography,
                                                            const Matches& calibrated) {
  const Eigen::JacobiSVD<Matrix3d> svd(homography, Eigen::ComputeFullV);
  const double second = svd.singularValues()[1];
  const double largest = svd.singularValues()[0] / second;
  const double least = svd.singularValues()[2] / second;
  if (!(largest > least)) return {};
  const Matrix3d h = scaled(homography, second, calibrated);
  const Vector3d v1 = svd.matrixV().col(0), v2 = svd.matrixV().col(1), v3 = svd.matrixV().col(2);
  const Vector3d along = std::sqrt((1 - least) * (1 + least)) * v1;
  const Vector3d across = std::sqrt((largest - 1) * (largest + 1)) * v3;
  std::array<PlanePose, 2> poses;
  for (const int sign : {1, -1}) {
    const Vector3d u = (along + sign * across).normalized(), n = v2.cross(u);
    Matrix3d before, after;
    before << v2, u, n;
    after << h * v2, h * u, (h * v2).cross(h * u);
    const Matrix3d rotation = after * before.transpose();
    const Vector3d shift = n - rotation.transpose() * h * n;
    poses[sign > 0 ? 0 : 1] = facing(rotation, n, shift, calibrated);
  }
  return poses;
}

namespace {

// The matches of the plane, and all others.
struct Split {
  Matches on_plane, others;
};

Split split(const Matches& matches, const std::vector<bool>& is_on_plane) {
  Split result;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    (is_on_plane[i] ? result.on_plane : result.others).push_back(matches[i]);
  }
  return result;
}

// The angle between the rays of two places in the left picture that are sigma apart, radians.
double angle_of_noise(const PlaneRequest& request) {
  const Matrix3d& intrinsic = request.left_intrinsic;
  return request.sigma / std::min(intrinsic(0, 0), intrinsic(1, 1));
}

// Refines a solution by the matches of the plane, and by others if these are to count. All matches
// beside the plane may be outliers.
PlaneSolution solved(const PlaneRequest& request, const PlanePose& first, const Split& pixels,
                     const Matches& others) {
  StereoRig rig{request.left_intrinsic, request.right_intrinsic, first.pose};
  const RefinedPlane refined =
      refined_plane(rig, first.plane, pixels.on_plane, others, request.threshold);
  PlaneSolution solution;
  solution.found = {refined.pose, refined.plane};
  rig.pose = refined.pose;
  const Matrix3d fundamental = fundamental_of(rig);
  // The inverse depth of a point of the plane with the ray p is m . p. Its error is that of m and
  // that of p.
  const double of_ray = angle_of_noise(request) * refined.plane.head<2>().norm();
  double squares = 0;
  for (const Match& match : pixels.on_plane) {
    const Vector3d ray = ray_through(rig.left_intrinsic, match.left);
    const double inverse_depth = refined.plane.dot(ray);
    const double of_plane = request.sigma * std::sqrt(ray.dot(refined.covariance * ray));
    solution.in_front += inverse_depth > 0;
    solution.behind += inverse_depth < -3 * (of_plane + of_ray);
    const double distance = sampson_distance(fundamental, match);
    squares += distance * distance;
  }
  solution.rms = std::sqrt(squares / double(pixels.on_plane.size()));
  for (const Match& match : pixels.others) {
    solution.others += std::abs(sampson_distance(fundamental, match)) <= request.threshold &&
                       midpoint(rays_of(match, rig.left_intrinsic, rig.right_intrinsic), rig.pose)
                           .in_front_of_both;
  }
  return solution;
}

// Whether two refinements have ended at one pose. They stop a little before the same end, so a
// difference is allowed that turns rays by a hundredth of the noise, or by rounding if this is
// more. Two poses of a plane that are so near each other are one for every use.
bool is_same(const RelativePose& a, const RelativePose& b, const PlaneRequest& request) {
  constexpr double kRounding = 1e-6;  // of a refinement, for a rotation and a vector of length 1
  const double most = std::max(kRounding, 0.01 * angle_of_noise(request));
  return (a.rotation - b.rotation).norm() + (a.translation - b.translation).norm() < most;
}

// A few matches that are near the homography by chance must not rule a solution out.
bool is_possible(const PlaneSolution& solution, std::size_t on_plane) {
  return solution.behind <= int(on_plane / 100);
}

// Outliers agree by chance with n1 matches for one solution, and with n2 for the other. Then the
// difference has about the standard deviation sqrt(n1 + n2).
bool is_by_chance(int one, int other) {
  return std::abs(one - other) <= 3 * std::sqrt(double(one + other));
}

}  // namespace

std::optional<PlaneAnalysis> analyse_plane(const PlaneRequest& request, const Matrix3d& homography,
                                           const std::vector<bool>& is_on_plane) {
  const Split pixels = split(request.pixels, is_on_plane);
  const Matrix3d of_rays = request.right_intrinsic.inverse() * homography * request.left_intrinsic;
  const auto poses = poses_of_homography(
      of_rays, calibrated(pixels.on_plane, request.left_intrinsic, request.right_intrinsic));
  if (!poses) return {};
  PlaneAnalysis analysis;
  analysis.on_plane = int(pixels.on_plane.size());
  auto& [one, other] = analysis.solutions;
  one = solved(request, (*poses)[0], pixels, pixels.others);
  other = solved(request, (*poses)[1], pixels, pixels.others);
  if (is_same(one.found.pose, other.found.pose, request)) {
    analysis.evidence = PlaneEvidence::kSame;
  } else if (is_possible(one, pixels.on_plane.size()) !=
             is_possible(other, pixels.on_plane.size())) {
    analysis.evidence = PlaneEvidence::kInFront;
    if (other.behind < one.behind) std::swap(one, other);
  } else if (!is_by_chance(one.others, other.others)) {
    analysis.evidence = PlaneEvidence::kOthers;
    if (other.others > one.others) std::swap(one, other);
  } else if (other.in_front > one.in_front ||
             (other.in_front == one.in_front && other.rms < one.rms)) {
    std::swap(one, other);
  }
  const bool is_chance = one.others <= other.others || is_by_chance(one.others, other.others);
  if (is_chance && analysis.evidence != PlaneEvidence::kSame) {
    // The matches beside the plane are outliers, which would only disturb it.
    one = solved(request, one.found, pixels, {});
    other = solved(request, other.found, pixels, {});
  }
  const StereoRig rig{request.left_intrinsic, request.right_intrinsic, one.found.pose};
  const Matrix3d refined = homography_of(rig, one.found.plane);
  double squares = 0;
  for (const Match& match : pixels.on_plane) {
    squares += transfer_residual(refined, match).squaredNorm() / 2;
  }
  analysis.rms = std::sqrt(squares / double(pixels.on_plane.size()));
  return analysis;
}

}  // namespace glassbox::views
