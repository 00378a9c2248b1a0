// The kind of a pair: whether its matches determine a relative pose at all (C-101 to C-103).
#pragma once

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::views {

enum class PairKind {
  kGeneral,       // the epipolar constraint, and no simpler model
  kPureRotation,  // one point of view: p_r = K_r R K_l^-1 p_l, E is 0, and any direction of T fits
  // A homography that is not a rotation: eight points leave a family of E; five calibrated points
  // do not.
  kPlane,
  // No homography, but a second constraint fits equally well: points and centres are on a ruled
  // quadric.
  kCritical,
};
const char* name_of(PairKind kind);

struct PairClassification {
  PairKind kind = PairKind::kGeneral;
  // The geometric robust information criterion (Torr, IJCV 50, 2002) of F, H and a rotation:
  // squared residuals over sigma^2, plus a cost for the model's structure and parameters. The
  // smallest one is the best explanation.
  double cost_of_fundamental = 0, cost_of_homography = 0, cost_of_rotation = 0;
  // For the system of eight-point equations with normalised points: the eighth singular value
  // divided by the ninth. If the ratio is small, a second matrix fits as well as the first.
  double eighth_over_ninth = 0;
};

// Classifies the inliers, in pixels, each coordinate of which has an error of `sigma` pixels; at
// least 8 are needed.
Result<PairClassification> classify_pair(const Matches& pixels, const Matrix3d& left_intrinsic,
                                         const Matrix3d& right_intrinsic, double sigma);

}  // namespace glassbox::views
