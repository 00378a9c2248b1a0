// Finds the camera from the glyphs in a picture (S1-25). Random samples of three or six points each
// give a camera; the camera that fits best shows which points are wrong, and is improved by least
// squares over all other points (the inliers).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/glyphs/find_glyphs.h"
#include "views/glyphs/wall.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

// A point of the world and its pixel. For a glyph, the point is the centre of a disc, and the pixel
// is the centre of the ellipse that is the disc's image, which is not exactly the image of the
// disc's centre.
struct PointCorrespondence {
  Vector3d world;
  Vector2d pixel;
  Vector3d right = Vector3d::Zero(),
           down = Vector3d::Zero();  // two perpendicular radii of the disc; zero: a point
};

// The centre of the ellipse that is the disc's image; for a point, its pixel. H = K R (r | d | c -
// C) maps the unit circle to the ellipse, where r and d are the disc's two radii, c is its centre,
// and C the camera's centre. The lines that touch the ellipse are described by the matrix H diag(1,
// 1, -1) H^T (the dual conic), and its product with the line at infinity, (0, 0, 1), is the centre.
Vector2d project_centre(const PinholeCamera& camera, const PointCorrespondence& point);

// The cameras with this K that see three points at these pixels: up to four (Grunert 1841, as in
// Haralick, Lee, Ottenberg and Noelle, Review and Analysis of Solutions of the Three Point
// Perspective Pose Estimation Problem, IJCV 13, 1994). None for three points on a line.
std::vector<PinholeCamera> cameras_from_three_points(
    const Matrix3d& intrinsic, const std::array<PointCorrespondence, 3>& points);

// The camera, including its lens, from six or more points that are not in one plane: solves the
// linear system for the projection's twelve entries, with normalised points (Hartley and Zisserman,
// Multiple View Geometry, chapter 7), and decomposes the result into K and R.
Result<PinholeCamera> camera_by_dlt(const std::vector<PointCorrespondence>& points);

// What is known of K: everything (kAll); that pixels are square and the principal point is in the
// picture's middle (kCentre); that pixels are square (kSquare).
enum class KnownIntrinsics { kAll, kCentre, kSquare };
std::string_view name_of(KnownIntrinsics known);

struct PoseRequest {
  KnownIntrinsics known = KnownIntrinsics::kCentre;
  Matrix3d intrinsic = Matrix3d::Identity();  // used by kAll
  int width = 0, height = 0;                  // of the picture, px: used by kCentre
  double threshold = 2;                       // px: a point further from its pixel is an outlier
};

struct FoundPose {
  PinholeCamera camera;
  std::vector<bool> is_inlier;  // for each point
  int inliers = 0;
  double rms = 0;  // root mean square of the inliers' distances, px
};

// Random samples with a fixed seed, then least squares over the inliers. Refused: fewer points than
// determine the camera (four for a known lens; six for an unknown one, not all in one plane), and a
// best camera that agrees with fewer points than these, or with less than half of all points.
Result<FoundPose> find_pose(const std::vector<PointCorrespondence>& points,
                            const PoseRequest& request);

// The found glyphs as points of the wall; `regions` has for each point the index of its region in
// `found`.
struct GlyphPoints {
  std::vector<PointCorrespondence> points;
  std::vector<std::size_t> regions;
};
GlyphPoints points_of(const FoundGlyphs& found, const Wall& wall);

// The angle of the rotation between two cameras in degrees, and the distance of their centres in
// world units.
struct PoseError {
  double degrees = 0, distance = 0;
};
PoseError pose_error(const PinholeCamera& camera, const PinholeCamera& truth);

}  // namespace glassbox::views
