// Numbers for messages: the shortest text that reads back as the same double, in every locale.
#pragma once

#include <charconv>
#include <string>

namespace glassbox {

inline std::string number_text(double value) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

}  // namespace glassbox
