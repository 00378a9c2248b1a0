// Sine, cosine and arctangent that give the same bytes on every machine. Fields of view, rotations,
// built-in shapes and light cones use them instead of libm, whose last bit differs from library to
// library. They use polynomials and argument reductions, which are IEEE double operations in a
// fixed order.
//
// Errors are in ulps of the exact result for the argument as given. tests/base/trig_test.cpp
// measures them against 50 digits; docs/conventions.md has the measured maxima.
#pragma once

namespace glassbox {

inline constexpr double kPi = 3.141592653589793238463;
inline constexpr double kHalfPi = 1.570796326794896619231;

// For larger angles sin_cos and sin_cos_degrees return NaN: the angles of a scene are only a few
// turns.
inline constexpr double kMaxRadians = 0x1p20;
inline constexpr double kMaxDegrees = 0x1p26;

struct SinCos {
  double sin = 0, cos = 1;
};

// Sine and cosine of an angle in radians. Each has an error below 1 ulp for |radians| <=
// kMaxRadians; both are NaN beyond that, and for NaN. The symmetries are exact: sin(-x) is -sin(x),
// cos(-x) is cos(x).
SinCos sin_cos(double radians);

// Sine and cosine of an angle in degrees, which is reduced exactly: multiples of 90 degrees give
// exactly 0, 1 and -1, and odd multiples of 45 give sine and cosine of exactly the same size. No
// result is -0. Error below 1 ulp for |degrees| <= kMaxDegrees; NaN beyond.
SinCos sin_cos_degrees(double degrees);

// cot(x/2) of an angle x, the scale of a perspective projection (S3-14). It is cos/sin, so that no
// tangent can overflow. Exactly 1 for a right angle (90 degrees; the double nearest to pi/2). Error
// below 2.5 ulps for 0 < x < 180 degrees; the limits are +inf at 0 and 0 at 180 degrees.
double cot_half(double radians);
double cot_half_degrees(double degrees);

// tan(x/2) of an angle of view x: half the height of a window at unit distance; 1 for a right
// angle. Error below 2.5 ulps for 0 <= x < 180 degrees.
double tan_half(double radians);
double tan_half_degrees(double degrees);

// The arctangent, in (-pi/2, pi/2). Error below 1 ulp. arctan(+-0) = +-0, arctan(+-inf) = +-pi/2,
// NaN for NaN.
double arctan(double x);

// The angle of (x, y) from the x axis, in [-pi, pi]; quadrants, zeros and infinities are those that
// IEEE 754 defines for atan2. Error below 2 ulps unless the result is subnormal.
double arctan2(double y, double x);

// The angle is multiplied by the rounded factor pi/180: error at most 1.5 ulps. Angles that a
// person wrote in degrees should go to the *_degrees functions instead, where 90 degrees stay
// exact.
constexpr double radians_from_degrees(double degrees) {
  return degrees * 0.017453292519943295769;
}
constexpr double degrees_from_radians(double radians) {
  return radians * 57.295779513082320877;
}

}  // namespace glassbox
