// Data in an HTML page: bytes as text, and JSON that can be put into a script element.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

namespace glassbox {

// Four characters for every three bytes, padded with "=" at the end, as data URIs need them.
std::string base64(std::span<const std::uint8_t> bytes);

// The bytes as one zlib stream in base64. html/inflate.js decodes it.
Result<std::string> compressed_base64(std::span<const std::uint8_t> bytes);

// <script type="application/octet-stream" id=ID>TEXT</script> and a line feed.
std::string data_block(std::string_view id, std::string_view text);

// <script type="application/json" id=ID> with JSON in ASCII. "<", which can occur in strings only,
// is escaped. Bytes that are not UTF-8 become U+FFFD.
std::string json_block(std::string_view id, const nlohmann::ordered_json& json);

}  // namespace glassbox
