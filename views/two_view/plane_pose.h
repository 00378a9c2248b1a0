// Two cameras that see a plane (C-102). A plane is given by a vector m: its points P have m . P =
// 1, in the left camera's space. So m is the plane's normal divided by the distance of the plane.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "views/two_view/triangulation.h"

namespace glassbox::views {

// The homography between the pixels of points on a plane: K_r R (I - T m^T) K_l^-1, because P_r = R
// (P_l - T) = R (P_l - T (m . P_l)).
Matrix3d homography_of(const StereoRig& rig, const Vector3d& plane);

// A pose and a plane that explain a homography. |T| is 1.
struct PlanePose {
  RelativePose pose;
  Vector3d plane = Vector3d::Zero();
};

// The two pairs of a pose and a plane that explain a homography of calibrated points. For each, the
// sign of T and the plane is the one with more of the matches in front of the cameras. The
// decomposition is in closed form (Ma, Soatto, Kosecka, Sastry, An Invitation to 3-D Vision, 2004,
// 5.3). None for the homography of a camera that only turned.
std::optional<std::array<PlanePose, 2>> poses_of_homography(const Matrix3d& homography,
                                                            const Matches& calibrated);

// One of the two, refined by all matches.
struct PlaneSolution {
  PlanePose found;
  int in_front = 0;  // matches of the plane in front of both cameras
  // Matches of the plane that are behind the cameras by more than the noise explains: their inverse
  // depth is below 0 by more than three standard deviations.
  int behind = 0;
  // Other matches in front of both cameras whose Sampson distance is within the threshold.
  int others = 0;
  double rms = 0;  // px: Sampson's distance of the plane's matches
};

// What decides between the two solutions. Both explain the matches of the plane equally well.
enum class PlaneEvidence {
  kInFront,  // the plane's points are in front of both cameras only in one of them
  kOthers,   // points beside the plane agree with one of them
  kSame,     // refined, both become the same pose
  // Both are possible. The one with more points in front of both cameras is put first, or, if these
  // are equally many, the one with the smaller residuals.
  kNothing,
};

struct PlaneAnalysis {
  std::array<PlaneSolution, 2> solutions;  // the chosen one is the first
  PlaneEvidence evidence = PlaneEvidence::kNothing;
  int on_plane = 0;  // matches that agree with the homography
  double rms = 0;    // px: the transfer residual of a coordinate of these matches
};

// The two solutions for matches in pixels, of which those with `is_on_plane` have this homography.
// A coordinate has an error of `sigma` pixels; `threshold` is that of the matches beside the plane,
// of which some or all may be outliers. None as for poses_of_homography.
struct PlaneRequest {
  const Matches& pixels;
  Matrix3d left_intrinsic, right_intrinsic;
  double sigma = 0.5, threshold = 1;
};
std::optional<PlaneAnalysis> analyse_plane(const PlaneRequest& request, const Matrix3d& homography,
                                           const std::vector<bool>& is_on_plane);

}  // namespace glassbox::views
