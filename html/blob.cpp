#include <glassbox/html/blob.h>

#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

namespace glassbox {
namespace {

using Bytes = std::vector<std::uint8_t>;

Result<Bytes> deflated(std::span<const std::uint8_t> bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  Bytes out(size);
  // Level 4 instead of the usual 6: for renderings the result is at most a tenth larger than with
  // 6, in a quarter of the time.
  if (compress2(out.data(), &size, bytes.data(), uLong(bytes.size()), 4) != Z_OK) {
    return fail("", "zlib could not compress a picture", "free some memory");
  }
  out.resize(size);
  return out;
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (i + j < bytes.size() ? bytes[i + j] : 0u);
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[group >> shift & 63];
  }
  for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) text[text.size() - 1 - i] = '=';
  return text;
}

Result<std::string> compressed_base64(std::span<const std::uint8_t> bytes) {
  const auto packed = deflated(bytes);
  if (!packed) return tl::unexpected(packed.error());
  return base64(*packed);
}

std::string data_block(std::string_view id, std::string_view text) {
  return fmt::format("<script type=\"application/octet-stream\" id=\"{}\">{}</script>\n", id, text);
}

std::string json_block(std::string_view id, const nlohmann::ordered_json& json) {
  const std::string text =
      json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, safe);
}

}  // namespace glassbox
