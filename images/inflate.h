// Decompresses deflate's data in zlib's format (RFC 1951, RFC 1950) in one go, by libdeflate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace glassbox {

// The largest ratio of deflate: it spends at least one bit on 129 bytes, because a match of 258
// bytes takes at least two bits. "zlib Technical Details" (zlib.net/zlib_tech.html) gives this
// ratio.
inline constexpr std::uint64_t kDeflateMaxRatio = 1032;

// Decompresses to exactly `target`. Returns how many bytes of `packed` it used, or nothing if they
// are not valid or give more or fewer bytes; `target` then has any bytes. The window that the
// header states is not checked. Throws std::bad_alloc.
std::optional<std::size_t> inflate_exactly(std::span<const std::byte> packed,
                                           std::span<std::byte> target);

}  // namespace glassbox
