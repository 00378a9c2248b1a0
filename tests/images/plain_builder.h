// Builds BMP and TGA files byte by byte.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tests/images/png_builder.h"

namespace glassbox::test {

inline void put_little(Bytes& bytes, std::size_t at, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes[at + i] = std::uint8_t(value >> 8 * i);
}

// Returns an uncompressed BMP with `bits` per pixel. `palette` has four bytes per colour; `rows`
// are in the file's order and padded.
inline Bytes build_bmp(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                       const Bytes& rows, const Bytes& palette = {}) {
  const auto pixels_at = std::uint32_t(54 + palette.size());
  Bytes bytes(pixels_at + rows.size());
  bytes[0] = 'B';
  bytes[1] = 'M';
  put_little(bytes, 2, pixels_at + std::uint32_t(rows.size()), 4);
  put_little(bytes, 10, pixels_at, 4);
  put_little(bytes, 14, 40, 4);
  put_little(bytes, 18, width, 4);
  put_little(bytes, 22, height, 4);
  put_little(bytes, 26, 1, 2);
  put_little(bytes, 28, bits, 2);
  std::copy(palette.begin(), palette.end(), bytes.begin() + 54);
  std::copy(rows.begin(), rows.end(), bytes.begin() + pixels_at);
  return bytes;
}

// Returns a TGA. The kinds are 1 palette, 2 colour, 3 grey, and 8 more if run-length encoded;
// `palette` has three bytes per colour.
inline Bytes build_tga(std::uint8_t kind, std::uint16_t width, std::uint16_t height,
                       std::uint8_t bits, const Bytes& samples, const Bytes& palette = {}) {
  const auto samples_at = std::ptrdiff_t(18 + palette.size());
  Bytes bytes(std::size_t(samples_at) + samples.size());
  bytes[2] = kind;
  if (!palette.empty()) {
    bytes[1] = 1;
    put_little(bytes, 5, std::uint32_t(palette.size() / 3), 2);
    bytes[7] = 24;
  }
  put_little(bytes, 12, width, 2);
  put_little(bytes, 14, height, 2);
  bytes[16] = bits;
  std::copy(palette.begin(), palette.end(), bytes.begin() + 18);
  std::copy(samples.begin(), samples.end(), bytes.begin() + samples_at);
  return bytes;
}

// Returns rows of bytes 10, 20, 30, 10 ...: one colour, in the order blue, green, red.
inline Bytes one_colour(std::size_t rows, std::size_t row_bytes) {
  Bytes bytes;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t i = 0; i < row_bytes; ++i) bytes.push_back(std::uint8_t(10 * (i % 3 + 1)));
  }
  return bytes;
}

}  // namespace glassbox::test
