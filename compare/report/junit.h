// Comparisons in JUnit's XML format, which continuous-integration servers read.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// One test suite named `suite`, with one test case for each picture: a failure where the pictures
// differ or one is missing or new, an error where they could not be compared; each with the time
// that the comparison took, in seconds. Characters that XML 1.0 cannot represent become U+FFFD.
std::string junit_report(const std::string& suite, std::span<const Comparison> comparisons);

}  // namespace glassbox
