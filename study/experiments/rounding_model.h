// Rounding errors as random numbers: what an error is likely to be, where a bound says what it can be at worst.
//
// A rounded result is anywhere within half a unit in its last place, evenly, and independent of the others (Henrici
// 1962; Higham and Mary 2019). An ulp of x = m 2^e, 1 <= m < 2, is 2 u 2^e, so that the error's mean square is
// (u/m)^2 x^2 / 3; over numbers whose m is spread evenly on a logarithmic scale the mean of 1/m^2 is 3 / (8 ln 2).
#pragma once

#include <cmath>

#include <glassbox/base/rounding.h>

namespace glassbox::study {

// Root mean square of a rounding error, relative to the number: u / sqrt(8 ln 2) = 0.4247 u.
template <class T>
inline constexpr double rms_rounding = 0.42466090014400953 * double(unit_roundoff<T>);

// Of a number that is rounded to a multiple of `step`: step / sqrt(12).
inline double rms_of_step(double step) {
  return step * 0.28867513459481288;
}

// E|x| of a normal distribution of mean 0 and deviation 1: sqrt(2/pi).
inline constexpr double kMeanOfNormal = 0.79788456080286536;

inline double square(double x) {
  return x * x;
}

}  // namespace glassbox::study
