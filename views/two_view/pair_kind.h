// The kind of a pair of pictures: whether its matches determine a relative pose at all (C-101 to
// C-103).
#pragma once

#include "views/two_view/camera.h"
#include "views/two_view/homography.h"
#include "views/two_view/match.h"

namespace glassbox::views {

enum class PairKind {
  kGeneral,       // the epipolar constraint holds, and no simpler model does
  kPureRotation,  // one point of view: p_r = K_r R K_l^-1 p_l, E is 0, and any direction of T fits
  // The model is a homography that is not a rotation: eight points leave a family of E; five
  // calibrated points do not.
  kPlane,
  // No homography fits, but a second epipolar constraint fits as well as the first: the points and
  // the cameras' centres are on a ruled quadric.
  kCritical,
};
const char* name_of(PairKind kind);

struct PairClassification {
  PairKind kind = PairKind::kGeneral;
  // The geometric robust information criterion (Torr, IJCV 50, 2002) of F, H and a rotation:
  // squared residuals over sigma^2, plus a cost for the model's structure and parameters. The model
  // with the smallest value is the best explanation.
  double cost_of_fundamental = 0, cost_of_homography = 0, cost_of_rotation = 0;
  // For the linear system of the eight-point algorithm with normalised points: the eighth singular
  // value divided by the ninth. If the ratio is small, a second matrix fits as well as the first.
  double eighth_over_ninth = 0;
  // The homography that most of the matches agree with, within three times their error.
  HomographyEstimate homography;
};

// Classifies a list of matches that agree with a fundamental matrix, in pixels. Some may agree by
// chance. Each coordinate has an error of `sigma` pixels; at least 8 matches are needed.
Result<PairClassification> classify_pair(const Matches& pixels, const Matrix3d& left_intrinsic,
                                         const Matrix3d& right_intrinsic, double sigma);

}  // namespace glassbox::views
