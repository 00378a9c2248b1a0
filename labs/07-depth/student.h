// Lab 7: which surface is in front. The contracts of the five functions that you write in
// student.cpp.
//
// Eye space is right-handed and the eye looks down -z: a point at the distance d along the gaze has
// z_eye = -d. A projection's last two rows give z_clip = a z_eye + b and w_clip = -z_eye = d; the
// divide gives depth = z_clip / w_clip. Distances are in world units, depth has no unit. u = 2^-53
// is the unit roundoff of double.
#pragma once

#include <cstdint>
#include <vector>

namespace lab_07 {

// kStandard: depth 0 on the near plane and 1 on the far plane. kReversed: 1 on the near plane and 0
// on the far plane.
enum class Range { kStandard, kReversed };

struct DepthRow {
  double a = 0, b = 0;
};

// Task 7.1. The entries [2][2] and [2][3] of a perspective projection. 0 < near < far; far may be
// infinite (depth then approaches 1, or 0, without reaching it). Each entry must be within 4 ulps
// of its exact value, which is below 2^1023 in size, and may be subnormal.
DepthRow depth_row(double near, double far, Range range);

// Task 7.2. The distance along the gaze that has this depth, 0 <= depth <= 1: the inverse of the
// mapping to depth. It is infinite for the depth of an infinite far plane. The relative error is at
// most 16 u, at the far plane too and for any ratio far / near. near, a finite far, and a depth
// other than 0 are at least 10^-100 and at most 10^100.
double distance_of(double depth, double near, double far, Range range);

// The formats of a depth buffer: 16 or 24 bits of fixed point, a float, or a float of the reversed
// range.
enum class Format { kUnorm16, kUnorm24, kFloat32, kFloat32Reversed };

// Task 7.3. The code of a depth; a smaller code is nearer. Depths below 0 count as 0 and those
// above 1 as 1 (rounding at a clipped edge makes such depths). Infinite depths are among them. No
// depth is NaN.
//   kUnorm16, kUnorm24  the nearest integer to depth (2^bits - 1), halves up: 0 .. 2^bits - 1
//   kFloat32            the 32 bits of the float as an integer, which for floats >= 0 grows with
//                       them
//   kFloat32Reversed    the bits of 1.0f minus the bits of the depth, so that depth 1 is nearest
// No error is allowed.
std::uint32_t depth_code(Format format, float depth);

struct Fragment {
  int pixel = 0;  // 0 .. pixels - 1
  float depth = 0;
};

// Task 7.4. A z-buffer: for each pixel the number of the fragment that is visible after all have
// been drawn in the given order, or -1 if the pixel has no fragment. Among fragments whose depths
// are stored as the same code of `format` the first one stays. The empty buffer is behind every
// depth, the depth of the far plane included.
std::vector<int> visible(const std::vector<Fragment>& fragments, int pixels, Format format);

// Task 7.5. A rung of the ladder, the resolution of a format at the distance d: how far apart,
// relative to d, two surfaces must be for their depths to differ by one step of the format. That is
// (d' - d)/d where |depth(d') - depth(d)| = step and d' > d. Depth is the exact depth of the
// format's range (kFloat32Reversed: reversed, all others: standard). The step is
//   kUnorm16, kUnorm24           1/(2^bits - 1)
//   kFloat32, kFloat32Reversed   the distance between neighbouring floats at depth(d):
//                                2^(e-23) with 2^e <= depth < 2^(e+1)
// Infinite if no d' up to the far plane is that far apart. near < d < far, far may be infinite,
// far >= 2 near. d differs from near and from far by at least 10^-4 of them, and d/near is at most
// 2^100; near is from 2^-101 to 2^101. Relative error at most 64 u; for a result r above 3 it is
// enough that 1/(1 + r), which is d/d', is off by at most 12 u. Where rounding decides, both
// answers are right: the steps on both sides of a power of two if depth(d) is within a relative
// 10^-11 of it, and a finite or an infinite result if 1/d' and 1/far differ by less than 10^-14 of
// 1/d. A finite one has the same error bounds there, as if there were no far plane; d/d' may be 0
// or less.
double separation(Format format, double near, double far, double d);

}  // namespace lab_07
