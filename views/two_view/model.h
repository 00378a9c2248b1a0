// What kind of pair this is: whether the matches have a relative pose in them at all (C-101 to C-103).
#pragma once

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::views {

enum class PairKind {
  kGeneral,  // the epipolar constraint, and nothing simpler
  kTurned,   // one point of view: p_r = K_r R K_l^-1 p_l, E is 0, and any direction of T fits
  kPlane,  // a homography that is no rotation: eight points leave a family of E; five calibrated ones do not
  kCritical,  // no homography, but a second constraint fits as well: points and centres on a ruled quadric
};
const char* name_of(PairKind kind);

struct PairJudgement {
  PairKind kind = PairKind::kGeneral;
  // The geometric robust information criterion (Torr, IJCV 50, 2002) of F, H and a rotation: squared residuals over sigma^2, and what
  // the model's structure and parameters cost. The smallest one is the best explanation.
  double cost_of_fundamental = 0, cost_of_homography = 0, cost_of_rotation = 0;
  // Of the system of eight-point equations with normalised points: how much further the eighth singular value is from nothing than
  // the ninth. Where it is not, a second matrix fits as well as the first.
  double eighth_over_ninth = 0;
};

// Of inliers in pixels, of which each coordinate has an error of `sigma` pixels; at least 8.
Result<PairJudgement> judge_pair(const Matches& pixels, const Matrix3d& left_intrinsic,
                                 const Matrix3d& right_intrinsic, double sigma);

}  // namespace glassbox::views
