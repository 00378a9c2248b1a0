#include <glassbox/matrices/decimal.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <glassbox/base/elementary.h>

namespace glassbox {

Decimal simplest_decimal(double value, double uncertainty) {
  constexpr int kMaxDigits = 17;  // enough for every double
  if (std::isnan(value)) return {value, kMaxDigits};
  if (std::isinf(value)) return {value, 1};
  if (std::abs(value) <= uncertainty) return {0, 0};
  for (int digits = 1; digits < kMaxDigits; ++digits) {
    char text[40];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
    double rounded = 0;
    std::from_chars(text, end.ptr, rounded);
    if (std::abs(rounded - value) <= uncertainty) return {rounded, digits};
  }
  return {value, kMaxDigits};
}

std::string rounded_text(double value, double uncertainty) {
  return short_number(simplest_decimal(value, uncertainty).value);
}

std::string short_number(double value, int digits) {
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
  if (value == 0) return "0";  // not "-0"
  return std::isnan(value) ? "nan" : std::string(text, end.ptr);
}

std::string short_vector_text(const glm::dvec3& v, int digits) {
  const double last =
      std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) * power_of_ten(-digits);
  const auto shown = [&](double x) { return short_number(std::abs(x) < last ? 0 : x, digits); };
  return "(" + shown(v.x) + ", " + shown(v.y) + ", " + shown(v.z) + ")";
}

}  // namespace glassbox
