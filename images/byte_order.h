// Numbers as files store them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glassbox {

// Returns the number of `size` bytes (at most 8) at an offset, least significant byte first.
inline std::uint64_t little_endian_at(std::span<const std::byte> bytes, std::size_t offset,
                                      std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | std::uint64_t(bytes[offset + i]);
  return value;
}

// Returns the number of 4 bytes at an offset, most significant byte first.
inline std::uint32_t big_endian_at(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(bytes[offset + i]);
  return value;
}

}  // namespace glassbox
