// Characters of UTF-8 text from files, which may be invalid.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glassbox {

// Removes the first character from the front of `text` and returns it. Returns none, and removes
// nothing, if `text` is empty or does not begin with valid UTF-8 (overlong forms and surrogates are
// not valid: Unicode 15, table 3-7).
inline std::optional<char32_t> take_character(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const auto byte = [&](std::size_t i) { return char32_t(static_cast<unsigned char>(text[i])); };
  const char32_t first = byte(0);
  const std::size_t length = first < 0x80    ? 1
                             : first < 0xc2  ? 0
                             : first < 0xe0  ? 2
                             : first < 0xf0  ? 3
                             : first <= 0xf4 ? 4
                                             : 0;
  if (length == 0 || length > text.size()) return std::nullopt;
  char32_t character = length == 1 ? first : first & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return std::nullopt;
    character = character << 6 | (byte(i) & 0x3f);
  }
  constexpr char32_t kLowest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = character >= 0xd800 && character <= 0xdfff;
  if (character < kLowest[length] || character > 0x10ffff || surrogate) return std::nullopt;
  text.remove_prefix(length);
  return character;
}

inline bool is_utf8(std::string_view text) {
  while (take_character(text)) {
  }
  return text.empty();
}

// Latin-1 (ISO 8859-1) uses the same character numbers as Unicode.
inline std::string utf8_of_latin1(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += char(0xc0 | byte >> 6);
      out += char(0x80 | (byte & 0x3f));
    }
  }
  return out;
}

}  // namespace glassbox
