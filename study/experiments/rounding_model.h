// Treats rounding errors as random numbers: predicts the likely size of an error, while a bound
// gives the worst case.
//
// A rounded result is uniformly distributed within half a unit in its last place (ulp), and
// independent of other rounded results (Henrici 1962; Higham and Mary 2019). An ulp of x = m 2^e, 1
// <= m < 2, is 2 u 2^e, where u is the unit roundoff, so the mean square of the error is (u/m)^2
// x^2 / 3. If m is uniformly distributed on a logarithmic scale, the mean of 1/m^2 is 3 / (8 ln 2).
#pragma once

#include <cmath>

#include <glassbox/base/rounding.h>

namespace glassbox::study {

// Root mean square of a rounding error, relative to the number: u / sqrt(8 ln 2) = 0.4247 u, with
// the unit roundoff u.
template <class T>
inline constexpr double rms_rounding = 0.42466090014400953 * double(unit_roundoff<T>);

// Root mean square error of a number that is rounded to a multiple of `step`: step / sqrt(12).
inline double rms_of_step(double step) {
  return step * 0.28867513459481288;
}

// The mean of |x| for a normal distribution with mean 0 and standard deviation 1: sqrt(2/pi).
inline constexpr double kMeanOfNormal = 0.79788456080286536;

inline double square(double x) {
  return x * x;
}

}  // namespace glassbox::study
