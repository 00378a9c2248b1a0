#include <glassbox/images/png_text.h>

#include <zlib.h>

#include <optional>
#include <string>
#include <string_view>

#include <glassbox/base/utf8.h>
#include <glassbox/images/png_read.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

// The parts of a chunk are its length, its type, its data, and a CRC of type and data (PNG, third
// edition, 5.3).
constexpr std::size_t kSignatureBytes = 8, kLengthBytes = 4, kTypeBytes = 4, kCrcBytes = 4;
constexpr std::size_t kMaxKeywordBytes = 79;

std::uint32_t number_at(Bytes bytes, std::size_t offset) {  // big-endian
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(bytes[offset + i]);
  return value;
}

std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Returns the text before the first zero byte; `rest` then begins after that byte.
std::optional<std::string_view> take_word(std::string_view& rest) {
  const std::size_t end = rest.find('\0');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return word;
}

bool is_text(std::string_view text) {
  return text.size() <= kMaxTextBytes && text.find('\0') == std::string_view::npos;
}

std::optional<std::string_view> take_keyword(std::string_view& rest) {
  const auto keyword = take_word(rest);
  if (!keyword || keyword->empty() || keyword->size() > kMaxKeywordBytes) return std::nullopt;
  return keyword;
}

// The data of a tEXt chunk are the keyword, 0, and the text (PNG, third edition, 11.3.3.2).
std::optional<TextEntry> entry_of_text(std::string_view data) {
  const auto keyword = take_keyword(data);
  if (!keyword || !is_text(data)) return std::nullopt;
  return TextEntry{utf8_of_latin1(*keyword), utf8_of_latin1(data)};
}

// The data of an iTXt chunk are the keyword, 0, whether it is compressed, the method, the language,
// 0, the translated keyword, 0, and the text (PNG, third edition, 11.3.3.4).
std::optional<TextEntry> entry_of_itxt(std::string_view data) {
  const auto keyword = take_keyword(data);
  if (!keyword || data.size() < 2 || data[0] != 0) return std::nullopt;
  data.remove_prefix(2);
  if (!take_word(data) || !take_word(data)) return std::nullopt;
  if (!is_text(data) || !is_utf8(data)) return std::nullopt;
  return TextEntry{utf8_of_latin1(*keyword), std::string(data)};
}

bool has_right_crc(Bytes type_and_data, std::uint32_t crc) {
  return ::crc32(0, reinterpret_cast<const Bytef*>(type_and_data.data()),
                 uInt(type_and_data.size())) == crc;
}

tl::unexpected<Error> broken(const std::string& cause) {
  return fail("PNG text", cause, "save the image again");
}

}  // namespace

Result<std::vector<TextEntry>> read_png_text(Bytes bytes) {
  std::vector<TextEntry> entries;
  if (!is_png(bytes)) return entries;
  Bytes rest = bytes.subspan(kSignatureBytes);
  while (entries.size() < kMaxTextEntries) {
    if (rest.size() < kLengthBytes + kTypeBytes + kCrcBytes) return broken("the file is cut off");
    const std::size_t length = number_at(rest, 0);
    if (length > rest.size() - (kLengthBytes + kTypeBytes + kCrcBytes)) {
      return broken("a chunk of " + std::to_string(length) +
                    " bytes runs past the end of the file");
    }
    const Bytes type_and_data = rest.subspan(kLengthBytes, kTypeBytes + length);
    const std::uint32_t crc = number_at(rest, kLengthBytes + kTypeBytes + length);
    rest = rest.subspan(kLengthBytes + kTypeBytes + length + kCrcBytes);

    const std::string_view type = text_of(type_and_data.first(kTypeBytes));
    if (type == "IEND") return entries;
    if (type != "tEXt" && type != "iTXt") continue;
    if (!has_right_crc(type_and_data, crc)) return broken("a text has the wrong check sum");
    const std::string_view data = text_of(type_and_data.subspan(kTypeBytes));
    auto entry = type == "tEXt" ? entry_of_text(data) : entry_of_itxt(data);
    if (entry) entries.push_back(std::move(*entry));
  }
  return entries;
}

}  // namespace glassbox
