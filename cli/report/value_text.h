// Values as text in reports.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include <glassbox/images/image.h>

namespace glassbox {

// The four bytes of a colour: "(255, 0, 0, 255)".
inline std::string bytes_text(const Rgba8& c) {
  return fmt::format("({}, {}, {}, {})", c.r, c.g, c.b, c.a);
}

// An error or its bound with three digits; "unknown" if there is no bound.
inline std::string number_or_unknown(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "unknown";
}

}  // namespace glassbox
