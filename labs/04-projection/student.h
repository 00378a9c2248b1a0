// Lab 4: from eye space to the screen. You write student.cpp; handout.md explains.
//
// Eye space is right-handed: x right, y up, the camera looks down -z. Clip space: w is the distance
// along the gaze. After the divide x and y are in [-1, 1], y up, and z in [0, 1], 0 at the near
// plane. The screen counts pixels from the top left, y down. Matrices act on columns:
// p_clip = m * p_eye, and m.at(row, column).
//
// u = 2^-53 is the unit roundoff of double. Every number of an answer must keep the error bound.
#pragma once

#include <optional>

#include <glassbox/base/spaces.h>

namespace lab_04 {

// The types of <glassbox/base/spaces.h>, which comes with glassbox; this is all that you need:
//   Point<Space, double>  p.x, p.y, p.z, and p.w too if Space is Clip
//   Projection            a 4 x 4 matrix of doubles, at first the identity: m.at(row, column),
//                         counted from 0
using glassbox::Clip;
using glassbox::Eye;
using glassbox::Ndc;
using glassbox::Point;
using glassbox::Screen;

using Projection = glassbox::Transform<Clip, Eye, double>;

// ---- 4.1 ----

// A perspective view around the gaze.
//   fovy_radians  the full vertical angle, in (0, pi), where pi is rounded to double: half a turn
//                 itself, 3.141592653589793, is not valid
//   aspect        width / height of the picture, positive and finite
//   near, far     distances along the gaze, 0 < near < far; far may be infinity
// Throws std::invalid_argument for anything else, NaN too. Valid numbers (but an infinite far) are
// from 2^-300 to 2^300, so that no product of two of them overflows. far may be the next double
// after near, or up to 2^600 times near. Error bound of each entry: 16 u times its size, so entries
// that are 0 are exact.
Projection perspective(double fovy_radians, double aspect, double near, double far);

// ---- 4.2 ----

// A parallel view. The box left <= x <= right, bottom <= y <= top, near <= distance <= far of eye
// space becomes the canonical volume, and w is 1. left < right, bottom < top, near < far, all
// finite; near may be negative. These numbers are at most 2^302 in size, and the two ends of a
// range differ by at least 2^-300. Error bound of each entry: 16 u times its size, so entries that
// are 0 are exact.
Projection orthographic(double left, double right, double bottom, double top, double near,
                        double far);

// ---- 4.3 ----

enum class Dialect {
  kOpenGl,    // z of clip space in -w .. w in place of 0 .. w
  kReversed,  // depth 1 at the near plane and 0 at the far one
  // for points of an eye space whose z grows into the scene; clip space stays as it is
  kLeftHandedEye
};

// The matrix that does in the dialect what `m` does in the conventions of this lab. `m` is any
// projection: any of its 16 entries may differ from 0; they are below 2^1000 in size. Error bound
// of each entry: 4 u times its size, so entries that are 0 are exact.
Projection in_dialect(const Projection& m, Dialect dialect);

// ---- 4.4 ----

// Clip space to NDC. Returns std::nullopt where w <= 0 (the point is at the eye or behind it and
// cannot be seen) and where w is NaN. w may be any other finite number, down to 2^-1074, the
// smallest double; x, y, z and their quotients are finite, too. Points with w = 1 keep their bits.
// Error bound of each coordinate: 4 u times its size, plus 2^-1074, the step of the smallest
// doubles.
std::optional<Point<Ndc, double>> divide(const Point<Clip, double>& p);

// ---- 4.5 ----

// A rectangle of the screen in pixels; `top` is its smallest y.
struct Rectangle {
  double left = 0, top = 0, width = 0, height = 0;
};

// NDC to pixels: (-1, 1) becomes the top left corner of the rectangle, (1, -1) the bottom right
// one. z keeps its bits. Error bounds: 8 u (|left| + width max(1, |x|)) for x, 8 u (|top| + height
// max(1, |y|)) for y. left, top, width and height are at most 2^32 in size, x and y below 2^64.
Point<Screen, double> to_screen(const Point<Ndc, double>& p, const Rectangle& viewport);

// ---- 4.6 ----

// The distance along the gaze that a depth in [0, 1] belongs to, in the perspective of 4.1. far may
// be infinity; depth 1 is then infinitely far away, and the answer is infinity. Any other far may
// be up to 2^80 times near, where near / far is much less than u. Error bound: 8 u z^2 / near, but
// at most z / 2, where z is the exact distance. The first is several times the error which the
// rounding of the depth alone causes; the second is the smaller one from 2^49 near on.
double distance_of(double depth, double near, double far);

}  // namespace lab_04
