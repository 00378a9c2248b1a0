// Builds PNG files of any colour type byte by byte and without libpng, to test the decoder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glassbox::test {

using Bytes = std::vector<std::uint8_t>;

inline void put32(Bytes& bytes, std::uint32_t value) {  // big-endian
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(value >> shift));
}

inline std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  return ~crc;
}

inline Bytes png_signature() {
  return {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
}

inline void put_chunk(Bytes& png, const std::string& type, const Bytes& data) {
  put32(png, std::uint32_t(data.size()));
  Bytes checked(type.begin(), type.end());
  checked.insert(checked.end(), data.begin(), data.end());
  png.insert(png.end(), checked.begin(), checked.end());
  put32(png, crc32(checked));
}

// Returns a zlib stream that stores its bytes (less than 64 KiB) uncompressed.
inline Bytes stored(const Bytes& data) {
  const auto size = std::uint16_t(data.size());
  Bytes stream{0x78,
               0x01,
               1,
               std::uint8_t(size),
               std::uint8_t(size >> 8),
               std::uint8_t(~size),
               std::uint8_t(std::uint16_t(~size) >> 8)};
  stream.insert(stream.end(), data.begin(), data.end());
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  put32(stream, b << 16 | a);
  return stream;
}

struct PngParts {
  std::uint32_t width = 1, height = 1;
  std::uint8_t bit_depth = 8,
               colour_type = 2;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  Bytes palette = {};            // PLTE, left out when empty
  Bytes transparency = {};       // tRNS, left out when empty
  Bytes rows = {};               // each row begins with its filter byte
  bool interlaced = false;       // then the rows are those of the seven passes
  Bytes extra = {};              // whole chunks, inserted before PLTE
};

// Returns a file whose IDAT chunk has `data`.
inline Bytes build_png_of(const PngParts& parts, const Bytes& data) {
  Bytes png = png_signature();
  Bytes header;
  put32(header, parts.width);
  put32(header, parts.height);
  for (const std::uint8_t byte : {parts.bit_depth, parts.colour_type}) header.push_back(byte);
  header.resize(13);  // deflate, adaptive filters
  header[12] = parts.interlaced ? 1 : 0;
  put_chunk(png, "IHDR", header);
  png.insert(png.end(), parts.extra.begin(), parts.extra.end());
  if (!parts.palette.empty()) put_chunk(png, "PLTE", parts.palette);
  if (!parts.transparency.empty()) put_chunk(png, "tRNS", parts.transparency);
  put_chunk(png, "IDAT", data);
  put_chunk(png, "IEND", {});
  return png;
}

inline Bytes build_png(const PngParts& parts) {
  return build_png_of(parts, stored(parts.rows));
}

}  // namespace glassbox::test
