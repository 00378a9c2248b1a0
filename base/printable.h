// Text from a file, made fit for one line of a terminal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glassbox/base/utf8.h>

namespace glassbox {

// Whether a character is shown as it is. A terminal obeys control characters (C0 and C1). Line and
// paragraph separators, and characters that change the direction of writing, can make a line of
// text look like another one (Unicode technical report 36, 2.7).
inline bool is_shown_as_itself(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool misleading = c == 0x061c || c == 0x200e || c == 0x200f ||  //
                          (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
  return !control && !misleading;
}

// Returns the text with '?' for each character that is not shown as itself and for each byte that
// is not part of valid UTF-8: names in files may be hostile. At most `max_length` bytes of the text
// are used, never a part of a character; if the text is longer, "..." follows.
inline std::string printable(std::string_view text, std::size_t max_length = 80) {
  std::string out;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view before = rest;
    const std::optional<char32_t> character = take_character(rest);
    if (!character) rest.remove_prefix(1);
    if (text.size() - rest.size() > max_length) return out + "...";
    const std::string_view bytes = before.substr(0, before.size() - rest.size());
    out += character && is_shown_as_itself(*character) ? bytes : "?";
  }
  return out;
}

inline std::string in_quotes(std::string_view text) {
  return std::string("'").append(printable(text)).append("'");
}

}  // namespace glassbox
