// Characters of text from files in UTF-8, which may be invalid, and from UTF-16 and Latin-1.
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

// The text without the mark with which some editors begin a file in UTF-8.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

// Appends a character, at most 0x10ffff.
inline void append_utf8(std::string& text, char32_t character) {
  const auto append_byte = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (character < 0x80) return append_byte(character);
  const int more = character < 0x800 ? 1 : character < 0x10000 ? 2 : 3;
  append_byte((0xff00u >> (more + 1) & 0xff) | character >> (6 * more));
  for (int i = more - 1; i >= 0; --i) append_byte(0x80 | (character >> (6 * i) & 0x3f));
}

enum class ByteOrder { kLittleEndian, kBigEndian };

// The byte order of text in UTF-16, which Windows programs write: it begins with the mark FF FE or
// FE FF, or with a printable ASCII character, tab or line end, of which one byte is zero. None for
// any other text.
inline std::optional<ByteOrder> utf16_byte_order(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const auto first = static_cast<unsigned char>(text[0]),
             second = static_cast<unsigned char>(text[1]);
  const unsigned one = first | second;
  const bool one_is_ascii =
      (one >= 0x20 && one < 0x7f) || one == '\t' || one == '\n' || one == '\r';
  if ((first == 0xff && second == 0xfe) || (second == 0 && one_is_ascii)) {
    return ByteOrder::kLittleEndian;
  }
  if ((first == 0xfe && second == 0xff) || (first == 0 && one_is_ascii)) {
    return ByteOrder::kBigEndian;
  }
  return std::nullopt;
}

// Text in UTF-16 as UTF-8, without a mark. Half of a pair of surrogates becomes U+FFFD, and an odd
// last byte is left out.
inline std::string utf8_of_utf16(std::string_view text, ByteOrder order) {
  const auto unit = [&](std::size_t i) {
    const std::size_t low = order == ByteOrder::kLittleEndian ? i : i + 1;
    return char32_t(static_cast<unsigned char>(text[low])) |
           char32_t(static_cast<unsigned char>(text[low == i ? i + 1 : i])) << 8;
  };
  constexpr char32_t kMark = 0xfeff, kReplacement = 0xfffd;
  std::string out;
  out.reserve(text.size() / 2);
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    char32_t character = unit(i);
    if (character == kMark && i == 0) continue;
    if (character >= 0xd800 && character < 0xe000) {
      const char32_t low = character < 0xdc00 && i + 3 < text.size() ? unit(i + 2) : 0;
      const bool pair = low >= 0xdc00 && low < 0xe000;
      character = pair ? 0x10000 + ((character - 0xd800) << 10 | (low - 0xdc00)) : kReplacement;
      if (pair) i += 2;
    }
    append_utf8(out, character);
  }
  return out;
}

// Latin-1 (ISO 8859-1) uses the same character numbers as Unicode.
inline std::string utf8_of_latin1(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) append_utf8(out, static_cast<unsigned char>(c));
  return out;
}

}  // namespace glassbox
