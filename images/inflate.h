// Decompresses deflate's data in zlib's format (RFC 1951, RFC 1950) in one go, by libdeflate.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace glassbox {

// The largest ratio of deflate: it spends at least one bit on 129 bytes, because a match of 258
// bytes takes at least two bits. "zlib Technical Details" (zlib.net/zlib_tech.html) gives this
// ratio.
inline constexpr std::uint64_t kDeflateMaxRatio = 1032;

// Whether the window that zlib's header states is as long as any distance in the data can be.
// libdeflate, and zlib's uncompress, decompress data with longer distances, too; libpng refuses
// most such data. The highest four bits of the header's first byte are the base-2 logarithm of the
// window's length, minus 8 (RFC 1950, 2.2).
inline bool has_wide_window(std::span<const std::byte> packed, std::size_t inflated_bytes) {
  constexpr std::size_t kLongestDistance = 32768;  // RFC 1951, 3.2.5
  if (packed.empty()) return false;
  const std::size_t window = std::size_t(256) << (std::to_integer<unsigned>(packed[0]) >> 4);
  return window >= std::min(inflated_bytes, kLongestDistance);
}

// Decompresses to exactly `target`. Returns how many bytes of `packed` it used, or nothing if they
// are not valid or give more or fewer bytes; `target` then has any bytes. The window that the
// header states is not checked. Throws std::bad_alloc.
std::optional<std::size_t> inflate_exactly(std::span<const std::byte> packed,
                                           std::span<std::byte> target);

}  // namespace glassbox
