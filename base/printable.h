// Text from a file, made fit for one line of a terminal.
#pragma once

#include <string>
#include <string_view>

namespace glassbox {

// Control characters become '?', and long text is cut (never inside a character): names in files
// may be hostile. Valid UTF-8 is kept.
inline std::string printable(std::string_view text, std::size_t max_length = 80) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  std::size_t end = text.size();
  if (end > max_length) {
    end = max_length;
    while (end > 0 && (byte(end) & 0xc0) == 0x80) --end;
  }
  std::string out;
  for (std::size_t i = 0; i < end; ++i) {
    // U+0080 to U+009F are control characters for terminals, too; in UTF-8 they are C2 80 to C2 9F.
    const bool second_set = byte(i) == 0xc2 && i + 1 < end && byte(i + 1) < 0xa0;
    if (second_set) ++i;
    out += second_set || byte(i) < 0x20 || byte(i) == 0x7f ? '?' : text[i];
  }
  if (end < text.size()) out += "...";
  return out;
}

inline std::string in_quotes(std::string_view text) {
  return std::string("'").append(printable(text)).append("'");
}

}  // namespace glassbox
