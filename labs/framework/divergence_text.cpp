#include "labs/framework/divergence_text.h"

#include <cmath>

#include <fmt/format.h>

namespace glassbox::labs {

namespace {

// The expected number as it is shown: 0 if it differs from 0 by no more than the bound, because the
// rounding errors of the expected answers do not concern the student.
double shown(const Divergence& found) {
  return std::abs(found.expected) <= found.bound ? 0 : found.expected;
}

std::string number_text(double value, double other) {
  std::string text = fmt::format("{:.9g}", value);
  return text == fmt::format("{:.9g}", other) ? fmt::format("{:.17g}", value) : text;
}

bool is_whole(double number) {
  return number == std::round(number);
}

}  // namespace

std::string expected_text(const Divergence& found) {
  return number_text(shown(found), found.actual);
}

std::string actual_text(const Divergence& found) {
  return number_text(found.actual, shown(found));
}

std::string distance_text(const Divergence& found) {
  if (found.kind == Divergence::Kind::kNotANumber)
    return "none, because a distance to NaN is not defined";
  std::string text =
      fmt::format("{:.6g}{}{}", found.distance, found.unit.empty() ? "" : " ", found.unit);
  const bool counted = found.unit.empty() && is_whole(found.expected) && is_whole(found.actual);
  // No distance in ulps is shown if 0 is expected: near 0 an ulp is so small that any error is a
  // huge number of ulps.
  if (std::isfinite(found.ulps) && !counted && shown(found) != 0)
    text += fmt::format(", {:.6g} {} ulps", found.ulps, found.ulps_of_double ? "double" : "float");
  if (found.bound == 0) return text + "; it must be exact";
  return text + fmt::format("; at most {:.6g} is allowed", found.bound);
}

}  // namespace glassbox::labs
