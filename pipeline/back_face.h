// Which faces turn away from the viewer, asked in object space, before anything is transformed (S4-13, S4.29, S4.36).
//
// A face is a back face iff (P - eye) . m > 0, where P is a vertex of this very face and m its outward Newell vector,
// all in one space (SPEC E18). In object space m needs no cofactor matrix, and no sign flips for mirrored models: what
// counter-clockwise order encloses here is the inside, whatever the model matrix does with it later.
//
// This test saves work; it does not decide the picture. The snapped area of raster/ does (DESIGN 2), so a triangle may
// be left out here only where the answer is safe from snapping: certainly_back().
#pragma once

#include <optional>
#include <span>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

// From where, or for parallel projections in which direction, an object is looked at.
struct ObjectViewer {
  bool perspective = true;
  // The eye point, or the gaze direction (any length, away from the viewer): object space.
  Vector<Object, double> eye_or_gaze;
  // How far each coordinate may be from that of the exact inverse of the matrix it came from.
  Vector<Object, double> error;
};

// Solves eye_from_object * eye = viewpoint, by Cramer's rule in double; `viewpoint` is the origin except for the eyes of
// a stereo pair that share one view matrix. Absent where the test cannot be made: a matrix that is singular within
// rounding (C-18), or an eye so far away or so finely placed that the exact fallback could overflow (2^200) - then every
// face has to be taken as a front face. Coordinates below 2^-200 are taken as zero.
std::optional<ObjectViewer> viewer_in_object_space(const Transform<Eye, Object>& eye_from_object,
                                                   bool perspective,
                                                   const Point<Eye, double>& viewpoint = {});

// kEdgeOn: the eye lies exactly in the face's plane, or the face has no area. It counts as front (C-27) and covers no
// pixel.
enum class Facing { kFront, kEdgeOn, kBack };

struct BackFaceTest {
  Facing facing = Facing::kFront;  // exactly right for the viewer as given
  double value = 0;                // (P - eye) . m as computed; cubic object units for perspective
  double bound = 0;  // its rounding error is no larger than this (SPEC C, generic bound 7)
  double viewer_error_bound = 0;  // how much the viewer's own error may add
  bool used_exact = false;        // |value| <= bound: expansions decided
};

// `polygon` holds the corners in counter-clockwise order seen from outside; fewer than three are edge-on. Positions are
// finite. The exact sign is that of the sum over the fan of determinants |V0 - eye, Vi - V0, Vi+1 - V0|, which is
// (V0 - eye) . m for the exact Newell vector m.
BackFaceTest test_back_face(std::span<const Point<Object>> polygon, const ObjectViewer& viewer);

// Whether the face may be left out: it would still be a back face after `snapping_margin` has been taken off its value.
inline bool certainly_back(const BackFaceTest& test, double snapping_margin) {
  return test.value > test.bound + test.viewer_error_bound + snapping_margin;
}

// The value below which snapping may turn a triangle round, for triangles that reach the raster stages uncut.
//
// The screen maps value to area: for a perspective view, twice the signed area in px^2 is
//     a = -(W H / 4) det(A) value / (w0 w1 w2),
// A being the 3x3 linear part of the rows x, y, w of clip_from_object and w0, w1, w2 the corners' w. Moving each
// coordinate of each corner by at most s moves each of the two edge vectors (u, v) of a = u x v by at most 2 s, hence a
// by at most 2 s (|u|_1 + |v|_1) + 8 s^2 <= 8 s L + 8 s^2 for edges of at most L px in x and in y. So a cannot change
// sign where value > (8 s L + 8 s^2) w^3 / ((W H / 4) |det A|). A parallel projection has w = 1 and
//     a = -(W H / 4) (row x) x (row y) . m,
// and the gaze g is a multiple of that cross product, so the factor is the ratio of the lengths.
//
// largest_w: of the corners; longest_edge_px: of |dx| and |dy| over the edges (the guard band's 2^16 is always safe);
// displacement_px: how far snapping (2^-9) and the rounding of the screen position together move a coordinate.
// Infinity, which keeps every face, where the matrix is singular.
double snapping_margin(const Transform<Clip, Object>& clip_from_object, const ObjectViewer& viewer,
                       const Viewport& viewport, double largest_w, double longest_edge_px,
                       double displacement_px);

}  // namespace glassbox
