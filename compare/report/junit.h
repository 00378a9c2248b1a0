// Comparisons as JUnit's XML, which continuous-integration servers read.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// One test suite, `suite` its name, and in it a test case for each picture: a failure where the pictures differ or one is
// missing or new, an error where they could not be compared. Text that XML 1.0 cannot hold becomes U+FFFD.
std::string junit_report(const std::string& suite, std::span<const Comparison> comparisons);

}  // namespace glassbox
