// Numbers in messages: the shortest text that is read back as the same double, in every locale.
#pragma once

#include <charconv>
#include <initializer_list>
#include <string>

namespace glassbox {

inline std::string number_text(double value) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

// Returns a text such as "(1, 2, 3)".
inline std::string triple_text(double x, double y, double z) {
  std::string text;
  for (double number : {x, y, z}) {
    text += text.empty() ? "(" : ", ";
    text += number_text(number);
  }
  text += ')';
  return text;
}

}  // namespace glassbox
