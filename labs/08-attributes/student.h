// Lab 8: the attributes that a triangle carries, and how finely a curved surface is divided. The
// contracts of the six functions that you write in student.cpp.
//
// Screen: x right, y down, in pixels; the centre of pixel (i, j) is at (i + 1/2, j + 1/2). w is the
// distance along the gaze. Over a triangle seen on the screen 1/w, u/w and v/w are linear; u, v and
// w are not. The unit roundoffs are u24 = 2^-24 of float and u53 = 2^-53 of double.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glassbox/base/spaces.h>

namespace lab_08 {

// The types of <glassbox/base/spaces.h>, which comes with glassbox; this is all that you need:
//   Point<Object, double>   p.x, p.y, p.z; p - q is a Vector, p + v a Point
//   Vector<Object, double>  v.x, v.y, v.z; v + w, v - w, -v, v * number; dot(v, w), cross(v, w)
using glassbox::Object;
using glassbox::Point;
using glassbox::Vector;

// ---- one pixel ----

// A triangle at a pixel centre. edges[k] is the edge function opposite vertex k: an exact integer
// from 0 to 2^51. edges[k] divided by the sum of the three is the weight of vertex k on the screen.
// The sum is positive. 1/w is from 2^-20 to 2^20, and a texture coordinate is 0 or from 2^-20 to
// 2^20 in magnitude.
struct PixelOfTriangle {
  std::array<std::int64_t, 3> edges{};
  std::array<float, 3> inverse_w{};
  std::array<std::array<float, 2>, 3> texcoords{};  // (u, v) of each vertex
};

// Task 8.1. (u, v) at the pixel centre, with perspective. Float is precise enough, if you choose
// well from where you interpolate.
// Error bound of u (v likewise): 16 u24 (b1 |u1 - u0| + b2 |u2 - u0|) + u24 |u|, where b0, b1, b2
// are the perspective-correct weights. A coordinate that is the same at all vertices must be exact,
// and coordinates around 10^6 must be as precise as a float can be.
std::array<float, 2> texcoord_at(const PixelOfTriangle& at);

// ---- a row of pixels ----

// A row of pixels. From x = 0 to x = `pixels` (on the borders of pixels, not their centres) a
// texture coordinate, in texels, goes from u0 to u1 and 1/w from inverse_w0 to inverse_w1. 1/w is
// from 2^-100 to 2^100, and a coordinate is 0 or from 2^-100 to 2^100 in magnitude.
// 1 <= pixels <= 4096.
struct Line {
  double u0 = 0, u1 = 0;
  double inverse_w0 = 1, inverse_w1 = 1;
  int pixels = 1;
};

// Task 8.2. The coordinate at the centre of each pixel, with a division only every `every` pixels:
// exact up to rounding at x = 0, every, 2 every, ... and at x = pixels (so the last span may be
// shorter), linear in between. 1 <= every <= pixels.
// Error bound: 2 (pixels + 8) R u53 |u|, where R is the larger 1/w over the smaller, and |u| the
// larger of |u0| and |u1|.
std::vector<double> span_coordinates(const Line& line, int every);

// The answer of task 8.3.
struct SpanChoice {
  int every = 0;     // pixels from division to division
  double error = 0;  // by the law of task 8.3, in texels; 0 for a division in every pixel
};

// Task 8.3. The longest span among 1, 2, 4, 8, ... <= pixels for which the law
//     |du| (sqrt r - 1) / (sqrt r + 1)
// gives at most `tolerance` texels in each span of the line, the last one too; and the largest of
// these errors. du is the change of u over the span, r >= 1 the ratio of the 1/w at its ends. A
// span of 1 means a division in every pixel, whose error is 0. If u0 = u1, du is exactly 0, and so
// is the error of every span: none is above any tolerance. Otherwise the error bound of the error
// is 64 R u53 |u|, with R and |u| as in task 8.2, and an error that differs from the tolerance by
// no more than this bound may count as above the tolerance or not: either answer is right. The
// tolerance is 0 or from 2^-130 to 2^110.
SpanChoice longest_span(const Line& line, double tolerance);

// ---- mip levels ----

// A vertex: its position on the screen, a multiple of 1/256 pixel and at most 2^15 pixels from 0
// along each axis; 1/w, from 2^-20 to 2^20; and texture coordinates, which are 0 or from 2^-20 to
// 2^20 in magnitude.
struct TexturedVertex {
  double x = 0, y = 0;
  double inverse_w = 1;
  double u = 0, v = 0;
};

struct Footprint {
  // How fast the texture coordinates change at the pixel centre, for each pixel along screen x
  // (right) and y (down).
  double du_dx = 0, du_dy = 0, dv_dx = 0, dv_dy = 0;
  // log2 of the longer of the two vectors (width du_dx, height dv_dx) and (width du_dy, height
  // dv_dy), whose unit is texels per pixel; but at least 0, and at most log2 of the larger of width
  // and height.
  double level = 0;
};

// Task 8.4. The footprint of the pixel whose centre is (x, y), in a texture of width x height
// texels, 1 to 2^14 each. The triangle has a non-zero area on the screen and either winding. The
// centre is in the triangle or on its outline. The derivatives are exact ones at (x, y), not
// differences to other pixels.
// Error bound of each derivative: 2048 k^2 (U / e) u53, where U is the largest |u| (or |v|), e the
// longer side of the triangle's bounding box, and k = (e^2 / twice its area) (largest 1/w / 1/w at
// the pixel). Error bound of the level: the error of the level that these errors cause.
Footprint footprint_at(const std::array<TexturedVertex, 3>& triangle, double x, double y, int width,
                       int height);

// ---- curved surfaces ----

// A bicubic Bezier patch. u grows along a row, v from row to row, and dS/du x dS/dv points
// outwards. A coordinate of a control point is 0 or from 2^-100 to 2^100 in magnitude.
struct Patch {
  std::array<std::array<Point<Object, double>, 4>, 4> rows;
};

struct Tessellation {
  std::vector<Point<Object, double>> positions;
  std::vector<std::array<int, 3>> triangles;  // indices into positions
};

// Task 8.5. The patch as level x level cells, 1 <= level <= 256.
// Positions: S(i / level, j / level) has the index j (level + 1) + i. Error bound of each
// coordinate: 64 u53 times the largest coordinate in size of a control point. On each of the four
// borders of the patch a position depends on the four control points of that border only, and has
// the same bits if they are given in the opposite order (but 0 and -0 count as the same):
// neighbouring patches must meet without a gap.
// Triangles: counter-clockwise seen from outside, cell by cell, i fastest. A cell with the corners
//     a = (i, j), b = (i + 1, j), c = (i + 1, j + 1), d = (i, j + 1)
// is (a, b, c) and then (a, c, d). If the four points of rows[0] are exactly the same, that row is
// a pole, and the cells at j = 0 are (a, c, d) alone. No other row or column counts as a pole.
Tessellation tessellate(const Patch& patch, int level);

// Task 8.6. The smallest level from 1 to 256 for which
//     (Muu + 2 Muv + Mvv) px_per_unit / (8 level^2) <= tolerance_px,
// or 256 if there is none. Muu, Muv and Mvv are the largest lengths of these vectors, the control
// points of the patch's second derivatives, over all i and j:
//     Muu: 6 (P[j][i + 2] - 2 P[j][i + 1] + P[j][i])      Mvv: the same along j
//     Muv: 9 (P[j + 1][i + 1] - P[j + 1][i] - P[j][i + 1] + P[j][i])
// with P[j][i] = rows[j][i]. px_per_unit and tolerance_px are from 2^-100 to 2^100.
// The differences of control points round. So if the two sides of the formula differ by no more
// than 512 u53 C px_per_unit / level^2 for a level, where C is the largest coordinate of a control
// point in size, that level may count as enough or not: either answer is right. But only one is
// where nothing has to round: if all control points are on one axis of the coordinates and are
// whole numbers below 2^24 in size, px_per_unit is a power of two, and tolerance_px is
// px_per_unit n/8 with a whole number n below 2^13.
int patch_level(const Patch& patch, double px_per_unit, double tolerance_px);

}  // namespace lab_08
