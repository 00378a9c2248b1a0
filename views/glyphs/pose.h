// From glyphs to the camera: three points or six, random samples against mistakes, and the least squares of all (SPEC S1-25).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/glyphs/find.h"
#include "views/glyphs/wall.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

// A point of the world and its pixel; of a glyph, the disc around that point, whose picture has its centre elsewhere than the point's.
struct SeenPoint {
  Vector3d world;
  Vector2d pixel;
  Vector3d right = Vector3d::Zero(),
           down = Vector3d::Zero();  // two radii of the disc, at right angles; zero: a point
};

// Where the centre of the disc's picture, an ellipse, is: of H = K R (r | d | c - C), the polar line of the horizon under the conic of
// the unit circle, H diag(1, 1, -1) H^T. Of a point its pixel.
Vector2d centre_seen(const PinholeCamera& camera, const SeenPoint& point);

// The cameras with this K from which three points are seen at these pixels: up to four (Grunert 1841, as in Haralick, Lee, Ottenberg and
// Noelle, Review and Analysis of Solutions of the Three Point Perspective Pose Estimation Problem, IJCV 13, 1994). None for three points
// of a line.
std::vector<PinholeCamera> cameras_of_three(const Matrix3d& intrinsic,
                                            const std::array<SeenPoint, 3>& points);

// The camera, lens included, of six points or more that are not in a plane: the linear system of the projection's twelve entries, with
// normalised points (Hartley and Zisserman, Multiple View Geometry, chapter 7), taken apart into K and R.
Result<PinholeCamera> camera_by_dlt(const std::vector<SeenPoint>& points);

// What is known of K: all; square pixels and the principal point in the picture's middle; square pixels.
enum class LensKnown { kAll, kCentre, kSquare };
std::string_view name_of(LensKnown known);

struct PoseQuestion {
  LensKnown known = LensKnown::kCentre;
  Matrix3d intrinsic = Matrix3d::Identity();  // kAll
  int width = 0, height = 0;                  // of the picture, px: kCentre
  double threshold = 2;                       // px: a point further off is a mistake
};

struct FoundPose {
  PinholeCamera camera;
  std::vector<bool> is_inlier;  // of each point
  int inliers = 0;
  double rms = 0;  // of the inliers' distances, px
};

// Random samples with a fixed seed, then the least squares of the inliers. Refused: fewer points than decide it (four of a known lens,
// six of an unknown one, not all in a plane), or so many mistakes that no camera agrees with half of that and more.
Result<FoundPose> find_pose(const std::vector<SeenPoint>& points, const PoseQuestion& question);

// What is found, as points of the wall; `of` has the region of each.
struct GlyphPoints {
  std::vector<SeenPoint> points;
  std::vector<std::size_t> of;
};
GlyphPoints points_of(const FoundGlyphs& found, const Wall& wall);

// Angle of the rotation between two cameras, degrees, and the distance of their centres, world units.
struct PoseError {
  double degrees = 0, distance = 0;
};
PoseError pose_error(const PinholeCamera& camera, const PinholeCamera& truth);

}  // namespace glassbox::views
