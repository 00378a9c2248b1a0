// Lays out text for a terminal, 100 columns wide.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <glassbox/images/image.h>

namespace glassbox {

inline constexpr std::size_t kTextWidth = 100;

// Breaks `text` into lines at blanks. The first line begins with `first`, and each further line
// with blanks of the same width. The result ends with a line break.
inline std::string wrapped(std::string_view first, std::string_view text) {
  std::string out(first);
  std::size_t column = first.size();
  bool begun = false;
  while (!text.empty()) {
    const std::size_t end = text.find(' ');
    const std::string_view word = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    if (word.empty()) continue;
    if (begun && column + 1 + word.size() > kTextWidth) {
      out += "\n" + std::string(first.size(), ' ');
      column = first.size();
    } else if (begun) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    begun = true;
  }
  return out + "\n";
}

// The four bytes of a colour: "(255, 0, 0, 255)".
inline std::string bytes_text(const Rgba8& c) {
  return fmt::format("({}, {}, {}, {})", c.r, c.g, c.b, c.a);
}

// An error or its bound with three digits; "unknown" if there is no bound.
inline std::string number_or_unknown(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "unknown";
}

// A field as in RFC 4180: in quotes if it contains a comma, a quote or a line break.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace glassbox
