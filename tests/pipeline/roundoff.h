// The unit roundoffs in which the tests of the pipeline state their bounds.
#pragma once

#include <glassbox/base/rounding.h>

namespace glassbox::test {

inline constexpr double u = unit_roundoff<double>;
inline constexpr double uf = unit_roundoff<float>, ud = u;  // where both kinds occur

}  // namespace glassbox::test
