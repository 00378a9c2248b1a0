// Logarithm, exponential, powers, cube root and hypotenuse that give the same bytes on every
// machine, as base/trig.h does for trigonometry. (The last digit of a C library's functions depends
// on the library, and on whether the processor has FMA.) They use polynomials and argument
// reductions, which are IEEE double operations in a fixed order, and square roots, which IEEE 754
// rounds correctly.
//
// For floats in loops there are faster, less accurate overloads of cube_root and power in
// images/colour/power.h.
//
// Errors are in ulps of the exact result for the arguments as given, unless the result is
// subnormal. tests/base/elementary_test.cpp measures them against 50 digits.
#pragma once

namespace glassbox {

// ln(x). Error below 1 ulp, and ln(1) = +0. -inf for +-0, +inf for +inf, NaN for NaN and below 0.
double logarithm(double x);

// ln(1 + x), accurate for small x, too. Error below 4 ulps. -inf for -1, NaN below.
double logarithm_1p(double x);

// e^x. Error below 1 ulp, and e^0 = 1. +inf beyond the largest double, 0 below the smallest, NaN
// for NaN.
double exponential(double x);

// x^y = e^(y ln x) for x > 0. Error below 1 + 3 |y ln x| ulps: it grows with the distance of the
// result from 1. 0^y is 0 for y > 0; the result is NaN for x < 0, for NaN, and for other powers of
// 0.
double power(double x, double y);

// x^n for n >= 0, by n - 1 multiplications from left to right, each of which rounds. x^0 is 1.
double whole_power(double x, int n);

// 10^n: exact from 10^0 to 10^22, correctly rounded from 10^-22 to 10^-1, and with |n| + 1
// roundings for other n. +inf above 10^308, 0 below 10^-308.
double power_of_ten(int n);

// The logarithms to base 2 and 10: ln(x) times a factor. The factor and the product are rounded,
// too: error below 2.5 ulps. The result is exact for powers of two to base 2, and for 10^-22 ..
// 10^22 to base 10.
double logarithm_2(double x);
double logarithm_10(double x);

// The real cube root, an odd function. Error below 2 ulps. +-0, infinities and NaN are returned as
// they are.
double cube_root(double x);

// sqrt(x^2 + y^2) and sqrt(x^2 + y^2 + z^2), also where the squares would overflow or underflow.
// Errors below 2 and 2.5 ulps. +inf if an argument is infinite, else NaN if one is NaN.
double hypotenuse(double x, double y);
double hypotenuse(double x, double y, double z);

}  // namespace glassbox
