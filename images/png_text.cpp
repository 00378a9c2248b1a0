#include <glassbox/images/png_text.h>

#include <zlib.h>

#include <optional>
#include <string>
#include <string_view>

#include <glassbox/base/utf8.h>
#include <glassbox/images/png_chunks.h>
#include <glassbox/images/png_read.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kMaxKeywordBytes = 79;

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

bool has_right_crc(const PngChunk& chunk) {
  const Bytes bytes = chunk.type_and_data;
  return ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())) == chunk.crc;
}

tl::unexpected<Error> broken(const std::string& cause) {
  return fail("PNG text", cause, "save the image again");
}

}  // namespace

Result<std::vector<TextEntry>> read_png_text(Bytes bytes) {
  std::vector<TextEntry> entries;
  if (!is_png(bytes)) return entries;
  Bytes rest = png_chunks(bytes);
  while (entries.size() < kMaxTextEntries) {
    const auto chunk = take_png_chunk(rest);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    if (chunk->type == "IEND") return entries;
    if (chunk->type != "tEXt" && chunk->type != "iTXt") continue;
    if (!has_right_crc(*chunk)) return broken("the checksum of a text is wrong");
    auto entry = chunk->type == "tEXt" ? entry_of_text(chunk->data) : entry_of_itxt(chunk->data);
    if (entry) entries.push_back(std::move(*entry));
  }
  return entries;
}

}  // namespace glassbox
