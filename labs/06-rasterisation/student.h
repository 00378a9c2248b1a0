// Lab 6: which pixels a triangle covers. The contracts of the six functions that you write in
// student.cpp.
//
// Everything is on the screen: x to the right, y DOWN, the origin at the top left corner. Pixel
// (i, j) is the square [i, i+1) x [j, j+1), and its sample point is its centre, (i + 1/2, j + 1/2).
// After the snap all positions are integers in steps of 1/256 pixel, |x|, |y| < 2^24, and nothing
// is rounded any more: no error is allowed anywhere in this lab.
//
// "Clockwise" means as seen on the screen.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/raster/stages.h>

namespace lab_06 {

using glassbox::PixelRect;      // pixels x0 <= x < x1, y0 <= y < y1
using glassbox::SnappedVertex;  // x, y in steps of 1/256 pixel

using Triangle = std::array<SnappedVertex, 3>;

inline constexpr std::int32_t kSteps = 256;   // steps in a pixel
inline constexpr std::int32_t kCentre = 128;  // steps from a pixel's corner to its centre

// Task 6.1. The nearest number of steps to a position in pixels. A position halfway between two
// numbers becomes the larger one: 3/512 becomes 2, and -3/512 becomes -1. |pixels| < 2^16. Every
// float is a multiple of some power of two, so "halfway" is exact too.
std::int32_t snap(float pixels);

// Task 6.2. The edge function of the directed edge from a to b at the point p: twice the signed
// area of the triangle a, b, p in steps squared. Positive where a, b, p run clockwise; so inside a
// clockwise triangle it is positive for all three edges (0, 1), (1, 2), (2, 0). Exact over the
// whole range of positions: count the bits.
std::int64_t edge(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p);

// Task 6.3. Whether the CLOCKWISE triangle with the directed edge from a to b owns the points on
// that edge: yes for a left edge (the triangle is to its right) and for a top edge (horizontal,
// with the triangle below); no for all others. a and b differ. For the triangle on the other side,
// the edge goes from b to a, so exactly one of the two triangles owns it.
bool owns_edge(const SnappedVertex& a, const SnappedVertex& b);

struct Pixel {
  int x = 0, y = 0;
};

// Task 6.4. The pixels of the window that a triangle covers, each once, in any order. A pixel is
// covered if its centre is inside the triangle, or is on its boundary and the triangle owns every
// edge that the centre is on. Either winding covers the same pixels. A triangle whose area is zero
// covers none. The window may begin at negative pixels, and a triangle may be 2^16 pixels larger
// than the window: look at no pixel outside the window.
std::vector<Pixel> covered_pixels(const Triangle& triangle, const PixelRect& window);

// Task 6.5. A fan from vertex k of a polygon is the set of triangles (k, k+i, k+i+1) for
// i = 1 .. N-2, with vertex numbers modulo N. Returns the smallest k whose fan has no two triangles
// of opposite winding (triangles of zero area have no winding), or 0 if there is no such k. N >= 3.
// The snap may bend a convex polygon inwards, and then not every fan covers it exactly once.
int fan_apex(const std::vector<SnappedVertex>& polygon);

enum class TileCover { kNone, kSome, kAll };

// Task 6.6. Classifies a tile of pixels for a triangle of non-zero area and either winding, edge by
// edge:
//   kNone  some edge has all centres of the tile on its outer side (or on it, if the triangle does
//          not own it)
//   kAll   every edge has all centres of the tile on its inner side (or on it, if the triangle owns
//          it)
//   kSome  neither
// The tile is not empty. However large it is, at most four centres need be tested for each edge.
TileCover classify_tile(const Triangle& triangle, const PixelRect& tile);

}  // namespace lab_06
