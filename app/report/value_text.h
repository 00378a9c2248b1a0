// Values as words of a report.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include <glassbox/images/image.h>

namespace glassbox::app {

// "(255, 0, 0, 255)", the four bytes of a colour.
inline std::string bytes_text(const Rgba8& c) {
  return fmt::format("({}, {}, {}, {})", c.r, c.g, c.b, c.a);
}

// An error or the bound of one, by three digits; "unknown" where there is no bound.
inline std::string number_or_unknown(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "unknown";
}

}  // namespace glassbox::app
