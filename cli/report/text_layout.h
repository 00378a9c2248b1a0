// Lays out text for a terminal, 100 columns wide.
#pragma once

#include <string>
#include <string_view>

namespace glassbox {

inline constexpr std::size_t kTextWidth = 100;

// `text` broken into lines at blanks. The first line begins with `first`, the others with as many
// blanks. Ends with a line break.
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

}  // namespace glassbox
