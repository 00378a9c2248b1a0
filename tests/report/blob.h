// Decodes a blob of a report page, written independently of page/decode.js, which the page itself
// uses.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <zlib.h>

#include <glassbox/compare/pixels/selection.h>

namespace glassbox::test {

inline std::vector<std::uint8_t> from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() % 4 != 0) throw std::runtime_error("base64 comes in groups of four");
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) throw std::runtime_error("no digit of base64");
    bits = bits << 6 | std::uint32_t(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(std::uint8_t(bits >> count));
  }
  return bytes;
}

// The samples of the boxes, one box after another.
template <class Sample>
std::vector<Sample> decode_blob(const std::string& text, std::span<const PixelBox> boxes,
                                int channels) {
  std::size_t pixels = 0;
  for (const PixelBox& box : boxes) pixels += std::size_t(box.width) * std::size_t(box.height);
  const std::vector<std::uint8_t> packed = from_base64(text);
  std::vector<Sample> samples(pixels * std::size_t(channels));
  // Room for one byte too many.
  std::vector<std::uint8_t> bytes(samples.size() * sizeof(Sample) + 1);
  uLongf size = uLongf(bytes.size());
  if (uncompress(bytes.data(), &size, packed.data(), uLong(packed.size())) != Z_OK ||
      size + 1 != bytes.size()) {
    throw std::runtime_error("not the zlib stream of these boxes");
  }
  std::size_t at = 0;
  for (const PixelBox& box : boxes) {
    const std::size_t stride = std::size_t(box.width * channels) * sizeof(Sample);
    const std::size_t end = at + stride * std::size_t(box.height);
    for (std::size_t i = at + stride; i < end; ++i) {
      bytes[i] = std::uint8_t(bytes[i] + bytes[i - stride]);
    }
    at = end;
  }
  std::memcpy(samples.data(), bytes.data(), at);
  return samples;
}

}  // namespace glassbox::test
