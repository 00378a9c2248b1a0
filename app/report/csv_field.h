// Comma-separated values.
#pragma once

#include <string>

namespace glassbox::app {

// A field as RFC 4180 asks for: in quotes where it has a comma, a quote or a line's end.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace glassbox::app
