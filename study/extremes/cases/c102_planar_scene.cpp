#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"
#include "views/two_view/analysis.h"
#include "views/two_view/constraint.h"
#include "views/two_view/plane_pose.h"

namespace glassbox::study {
namespace c102 {

using Essentials = std::vector<views::Matrix3d>;

// Computes the rank of the system of eight-point equations, and the essential matrix. A second
// matrix means that both are possible.
struct Subject102 {
  int (*rank)(const views::Matches& calibrated);
  Essentials (*essentials)(const views::Matches& pixels, const views::StereoRig& rig);
};

int by_singular_values(const views::Matches& matches) {
  return views::linear_fit(views::normalised(matches)->matches)->rank();
}
int count_equations(const views::Matches& matches) {
  return std::min(int(matches.size()), 8);
}
int count_nonzero_values(const views::Matches& matches) {
  const auto fit = views::linear_fit(views::normalised(matches)->matches);
  return int((fit->singular_values.array() != 0).count());
}

views::Matrix3d essential_of(const views::RelativePose& pose) {
  return views::essential<double>(pose.rotation, pose.translation);
}
std::optional<views::PairAnalysis> analysed(const views::Matches& pixels,
                                            const views::StereoRig& rig) {
  views::PairRequest request;
  request.matches = pixels;
  request.intrinsics = {rig.left_intrinsic, rig.right_intrinsic};
  request.sigma = 1e-3;  // px: the matches are exact
  request.ransac.threshold = 2e-3;
  const auto analysis = views::analyse(request);
  return analysis && analysis->pose ? std::optional(*analysis) : std::nullopt;
}
Essentials chosen(const views::Matches& pixels, const views::StereoRig& rig) {
  const auto analysis = analysed(pixels, rig);
  if (!analysis) return {};
  Essentials found{essential_of(*analysis->pose)};
  if (analysis->plane && analysis->plane->evidence == views::PlaneEvidence::kNothing) {
    found.push_back(essential_of(analysis->plane->solutions[1].found.pose));
  }
  return found;
}
// Decides for the first solution, as if only one fitted.
Essentials fitting(const views::Matches& pixels, const views::StereoRig& rig) {
  const auto analysis = analysed(pixels, rig);
  if (!analysis || !analysis->plane) return chosen(pixels, rig);
  const views::Matrix3d of_rays = rig.right_intrinsic.inverse() *
                                  analysis->classification.homography.homography *
                                  rig.left_intrinsic;
  const auto poses = views::poses_of_homography(of_rays, calibrated(pixels, rig));
  return {essential_of((*poses)[0].pose)};
}
Essentials eight_points(const views::Matches& pixels, const views::StereoRig& rig) {
  return {views::fit_essential(calibrated(pixels, rig), views::Conditioning::kNormalised)->matrix};
}

// Whether a second pose has all points of the plane in front of both cameras, too. With the plane's
// vector m, the homography is H = R (I - T m^T), and H^T H - I = m w^T + w m^T, where w = |T|^2 m/2
// - T. So w is the other normal that explains it, and all points have to be on one side of it.
bool has_possible_twin(const views::StereoRig& rig, const views::Matches& matches) {
  views::Vector3d plane;  // by three points, which have m . P = 1
  views::Matrix3d points;
  for (int i = 0; i < 3; ++i) {
    const views::Match& m = matches[std::size_t(i)];
    const views::Rays rays{m.left.homogeneous(), m.right.homogeneous()};
    points.row(i) = views::midpoint(rays, rig.pose).point.head<3>();
  }
  plane = points.inverse() * views::Vector3d::Ones();
  const views::Vector3d& t = rig.pose.translation;
  const views::Vector3d other = t.squaredNorm() * plane / 2 - t;
  const auto in_front = std::ranges::count_if(
      matches, [&](const views::Match& match) { return other.dot(match.left.homogeneous()) > 0; });
  return in_front == 0 || in_front == std::ptrdiff_t(matches.size());
}

bool is_right(const Essentials& found, const views::Matrix3d& right, bool has_twin) {
  if (found.size() != (has_twin ? 2 : 1)) return false;
  return std::ranges::any_of(
      found, [&](const views::Matrix3d& e) { return matrix_distance(e, right) <= 1e-6; });
}

Outcome measure_error(auto rank_by, auto essentials_by) {
  const Subject102 subject{rank_by, essentials_by};
  Random random(102);
  int wrong = 0, tried = 0;
  for (int i = 0; i < 30; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matrix3d right = views::essential<double>(rig.pose.rotation, rig.pose.translation);
    for (const bool flat : {true, false}) {
      const views::Matches pixels =
          flat ? matches_of_plane(random, rig, 20, 0) : matches_of(random, rig, 20, 0);
      const views::Matches matches = calibrated(pixels, rig);
      wrong += subject.rank(matches) != (flat ? 6 : 8);
      const bool has_twin = flat && has_possible_twin(rig, matches);
      wrong += !is_right(subject.essentials(pixels, rig), right, has_twin);
      tried += 2;
    }
  }
  return wrong_count_outcome(wrong, tried, "answers are wrong");
}

}  // namespace c102

ExtremeCase c102_planar_scene() {
  using namespace c102;
  return {
      .id = "C-102",
      .name = "All points on a plane",
      .construction =
          "30 pairs of cameras, 20 matches without noise, of points on a plane and of points in "
          "any position",
      .stage = "two views",
      .right_answer =
          "the rank of the system is 6, and 8 for points in any position; E is right to 1e-6 "
          "(roots of degree 10 lose half of the digits). A homography has two E: if only one has "
          "all points in front of both cameras, it is chosen; if both have, both are named",
      .unit = "answers",
      .oracle = Oracle::kAnalytic,
      .ours = {"the rank from singular values, and the pose that the points allow",
               [] { return measure_error(by_singular_values, chosen); }},
      .naive = {"the rank is taken to be the number of matches, and the eight-point solution",
                [] { return measure_error(count_equations, eight_points); }},
      .mutants = {{"only singular values of exactly 0 count as 0",
                   [] { return measure_error(count_nonzero_values, chosen); }},
                  {"the eight-point solution",
                   [] { return measure_error(by_singular_values, eight_points); }},
                  {"the first of the two poses that explain the homography",
                   [] { return measure_error(by_singular_values, fitting); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
