// Marks of charts in SVG. A `style` is a class of the style sheet.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include <glassbox/html/escaped.h>

namespace glassbox::app {

// `anchor`: which end of the text stands at x, "start", "middle" or "end".
inline std::string svg_text(double x, double y, const std::string& style, const char* anchor,
                            const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\" text-anchor=\"{}\">{}</text>\n",
                     x, y, style, anchor, escaped(text));
}

inline std::string svg_line(const std::string& style, double x0, double y0, double x1, double y1) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style, x0,
      y0, x1, y1);
}

// 1, 2 or 5 times a power of ten, so that the range has at most `most` steps.
inline double tick_step(double range, int most) {
  const double least = range / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

}  // namespace glassbox::app
