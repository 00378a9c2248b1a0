// Decides in object space which faces turn away from the viewer, before anything is transformed
// (S4-13, S4.29, S4.36).
//
// A face is a back face iff (P - eye) . m > 0, where P is a vertex of this very face and m its
// outward Newell vector, all in one space (E18). In object space m needs no cofactor matrix, and
// its sign need not be changed for mirrored models: counter-clockwise order means "seen from
// outside" here, regardless of what the model matrix does later.
//
// This test saves work; it does not decide the picture. The picture is decided by the sign of the
// triangle's area after snapping to the subpixel grid (raster/). So this test may leave a triangle
// out only if snapping cannot change the sign: see certainly_back().
#pragma once

#include <optional>
#include <span>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// The point from which an object is looked at, or for parallel projections the direction.
struct ObjectViewer {
  bool perspective = true;
  // The eye point, or the gaze direction (any length, pointing away from the viewer), in object
  // space.
  Vector<Object, double> eye_or_gaze;
  // An upper bound of each coordinate's error, compared with the exact inverse of the given matrix.
  Vector<Object, double> error;
};

// Solves eye_from_object * eye = viewpoint, by Cramer's rule in double. `viewpoint` is the origin
// except for the eyes of a stereo pair that share one view matrix. Returns nothing where the test
// cannot be made: for a matrix that is singular within rounding (C-18), or for an eye so far away
// or with such fine digits that the exact fallback could overflow (2^200). Then every face has to
// be taken as a front face. Coordinates below 2^-200 are taken as zero.
std::optional<ObjectViewer> viewer_in_object_space(const Transform<Eye, Object>& eye_from_object,
                                                   bool perspective,
                                                   const Point<Eye, double>& viewpoint = {});

// kEdgeOn: the eye is exactly in the face's plane, or the face has no area. Such a face is treated
// as a front face (C-27); it covers no pixel.
enum class Facing { kFront, kEdgeOn, kBack };

struct BackFaceTest {
  Facing facing = Facing::kFront;  // exactly right for the given viewer
  // (P - eye) . m as computed (top of file), in cubic object units; parallel: gaze . m.
  double value = 0;
  double bound = 0;  // upper bound of the rounding error of `value` (docs/references.md, bound 7)
  double viewer_error_bound = 0;  // upper bound of the error of `value` from the viewer's error
  bool used_exact = false;        // |value| <= bound: exact arithmetic (expansions) decided
};

// `polygon` holds the corners in counter-clockwise order seen from outside; fewer than three
// corners are edge-on. Positions are finite. The exact sign is the sign of the sum of the
// determinants |V0 - eye, Vi - V0, Vi+1 - V0| over the triangles (V0, Vi, Vi+1) of the corners'
// fan; this sum is (V0 - eye) . m for the exact Newell vector m.
BackFaceTest test_back_face(std::span<const Point<Object>> polygon, const ObjectViewer& viewer);

// Whether the face may be left out: it is still a back face after `snapping_margin` is subtracted
// from its value.
inline bool certainly_back(const BackFaceTest& test, double snapping_margin) {
  return test.value > test.bound + test.viewer_error_bound + snapping_margin;
}

// If a triangle's BackFaceTest::value is below this margin, snapping may reverse the triangle's
// winding. It holds for triangles that reach the raster stages without being clipped.
//
// Reason: `value` is proportional to the area on the screen. For a perspective view and a viewport
// of W x H pixels, twice the signed area in px^2 is
//     a = -(W H / 4) det(A) value / (w0 w1 w2),
// A being the 3x3 linear part of the rows x, y, w of clip_from_object and w0, w1, w2 the corners'
// w. Moving each coordinate of each corner by at most s moves each of the two edge vectors (u, v)
// of a = u x v by at most 2 s, hence a by at most 2 s (|u|_1 + |v|_1) + 8 s^2 <= 8 s L + 8 s^2 for
// edges of at most L px in x and in y. So a cannot change sign where value > (8 s L + 8 s^2) w^3 /
// ((W H / 4) |det A|). A parallel projection has w = 1 and
//     a = -(W H / 4) (row x) x (row y) . m,
// and the gaze g is a multiple of that cross product, so |det A| is replaced by the ratio of their
// lengths.
//
// largest_w: the largest w of the corners. longest_edge_px: the largest |dx| or |dy| of the edges
// (the guard band's 2^16 is always safe). displacement_px: how far snapping (2^-9) and the rounding
// of the screen position together can move a coordinate. Returns infinity, which keeps every face,
// where the matrix is singular.
double snapping_margin(const Transform<Clip, Object>& clip_from_object, const ObjectViewer& viewer,
                       const Viewport& viewport, double largest_w, double longest_edge_px,
                       double displacement_px);

}  // namespace glassbox
