#include <glassbox/images/exr_unpack.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include <glassbox/images/exr_piz.h>
#include <glassbox/images/inflate.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;
using ExrBytes = std::vector<std::byte>;

// Decompresses zlib's format into exactly `size` bytes.
std::optional<ExrBytes> inflate_exr(Bytes packed, std::size_t size) {
  ExrBytes bytes(size);
  if (!inflate_exactly(packed, bytes)) return std::nullopt;
  return bytes;
}

// Undoes run lengths: a negative count is followed by as many bytes, and any other one by a byte
// that is repeated once more than the count says.
std::optional<ExrBytes> undo_runs(Bytes packed, std::size_t size) {
  ExrBytes bytes;
  bytes.reserve(size);
  while (!packed.empty()) {
    const int count = std::int8_t(packed[0]);
    const auto run = std::size_t(count < 0 ? -count : count + 1);
    const std::size_t stored = count < 0 ? run : 1;
    if (packed.size() - 1 < stored || size - bytes.size() < run) return std::nullopt;
    if (count < 0) {
      bytes.insert(bytes.end(), packed.begin() + 1, packed.begin() + 1 + std::ptrdiff_t(run));
    } else {
      bytes.insert(bytes.end(), run, packed[1]);
    }
    packed = packed.subspan(1 + stored);
  }
  if (bytes.size() != size) return std::nullopt;
  return bytes;
}

// RLE and ZIP compress the bytes at even places, then those at odd places, each as its difference
// from the one before plus 128.
ExrBytes undo_differences(const ExrBytes& bytes) {
  ExrBytes ordered(bytes.size());
  const std::size_t even = (bytes.size() + 1) / 2;
  unsigned sum = 128;  // the first byte is stored as it is
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    sum += unsigned(bytes[i]) - 128u;
    ordered[i < even ? 2 * i : 2 * (i - even) + 1] = std::byte(std::uint8_t(sum));
  }
  return ordered;
}

void put_number(std::byte* to, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) to[i] = std::byte(std::uint8_t(value >> 8 * i));
}

// PXR24 leaves out the lowest byte of floats. In a row of a channel, it compresses the highest
// bytes of all samples, then the next ones, and so on. A sample is the sum of all up to it.
std::optional<ExrBytes> undo_pxr24(Bytes packed, const ExrChunk& chunk) {
  const auto kept_bytes = [](const ExrChannel& channel) {
    return channel.type == ExrType::kFloat ? std::size_t(3) : channel.bytes();
  };
  std::size_t pixel_bytes = 0;
  for (const ExrChannel& channel : chunk.channels) pixel_bytes += kept_bytes(channel);
  const auto planes = inflate_exr(packed, chunk.width * chunk.height * pixel_bytes);
  if (!planes) return std::nullopt;
  ExrBytes samples(chunk.bytes());
  const std::byte* from = planes->data();
  std::byte* to = samples.data();
  for (std::size_t y = 0; y < chunk.height; ++y) {
    for (const ExrChannel& channel : chunk.channels) {
      const std::size_t kept = kept_bytes(channel), size = channel.bytes();
      std::uint32_t sum = 0;
      for (std::size_t x = 0; x < chunk.width; ++x, to += size) {
        std::uint32_t difference = 0;
        for (std::size_t i = 0; i < kept; ++i) {
          difference = difference << 8 | std::uint32_t(from[i * chunk.width + x]);
        }
        sum += difference << 8 * (size - kept);
        put_number(to, sum, size);
      }
      from += kept * chunk.width;
    }
  }
  return samples;
}

// ---- B44 ----

using B44Block = std::array<std::uint16_t, 16>;  // 4 x 4 halves, row by row

// B44 orders the bits of halves as their values are ordered.
std::uint16_t half_of_ordered(std::uint16_t bits) {
  return std::uint16_t((bits & 0x8000u) ? bits & 0x7fffu : ~unsigned(bits));
}

// Removes a block from the front: its first half, then a shift of 6 bits, and 15 differences of 6
// bits: down the first column, and then in every row from the sample on the left. With a shift of
// 13 or more there are no differences (B44A).
std::optional<B44Block> take_block(Bytes& packed) {
  constexpr std::size_t kFlatBytes = 3, kBytes = 14;
  constexpr unsigned kFlatShift = 13;
  if (packed.size() < kFlatBytes) return std::nullopt;
  const auto first = std::uint16_t(unsigned(packed[0]) << 8 | unsigned(packed[1]));
  const unsigned shift = unsigned(packed[2]) >> 2;
  const bool is_flat = shift >= kFlatShift;
  if (!is_flat && packed.size() < kBytes) return std::nullopt;
  B44Block block;
  block.fill(first);
  for (std::size_t i = 1; i < block.size() && !is_flat; ++i) {
    // The i-th difference follows 16 bits of the half and 6 bits of the shift.
    const std::size_t bit = 16 + 6 * i;
    const unsigned two_bytes =
        unsigned(packed[bit / 8]) << 8 | (bit / 8 + 1 < kBytes ? unsigned(packed[bit / 8 + 1]) : 0);
    const unsigned difference = two_bytes >> (10 - bit % 8) & 63u;
    const std::size_t column = i / 4, row = i % 4, at = row * 4 + column;
    const std::size_t before = column == 0 ? at - 4 : at - 1;
    block[at] = std::uint16_t(block[before] + (difference << shift) - (32u << shift));
  }
  for (std::uint16_t& bits : block) bits = half_of_ordered(bits);
  packed = packed.subspan(is_flat ? kFlatBytes : kBytes);
  return block;
}

// Reads the blocks of a channel of halves to `to`, whose rows are `stride` bytes apart.
bool undo_blocks(Bytes& packed, const ExrChunk& chunk, std::byte* to, std::size_t stride) {
  for (std::size_t top = 0; top < chunk.height; top += 4) {
    for (std::size_t left = 0; left < chunk.width; left += 4) {
      const auto block = take_block(packed);
      if (!block) return false;
      for (std::size_t y = top; y < std::min(top + 4, chunk.height); ++y) {
        for (std::size_t x = left; x < std::min(left + 4, chunk.width); ++x) {
          put_number(to + y * stride + 2 * x, (*block)[4 * (y - top) + x - left], 2);
        }
      }
    }
  }
  return true;
}

// B44 stores one channel after the other: halves as blocks, all others as they are.
std::optional<ExrBytes> undo_b44(Bytes packed, const ExrChunk& chunk) {
  ExrBytes samples(chunk.bytes());
  const std::size_t stride = samples.size() / chunk.height;
  std::byte* to = samples.data();
  for (const ExrChannel& channel : chunk.channels) {
    const std::size_t row = chunk.width * channel.bytes();
    if (channel.type == ExrType::kHalf) {
      if (!undo_blocks(packed, chunk, to, stride)) return std::nullopt;
    } else {
      if (packed.size() < row * chunk.height) return std::nullopt;
      for (std::size_t y = 0; y < chunk.height; ++y, packed = packed.subspan(row)) {
        std::ranges::copy(packed.first(row), to + y * stride);
      }
    }
    to += row;
  }
  return samples;
}

}  // namespace

std::size_t ExrChunk::bytes() const {
  return width * height * exr_pixel_bytes(channels);
}

std::optional<ExrBytes> unpack_exr(Bytes packed, ExrCompression compression,
                                   const ExrChunk& chunk) {
  const std::size_t size = chunk.bytes();
  // What compression would make longer is stored as it is.
  if (packed.size() == size) return ExrBytes(packed.begin(), packed.end());
  if (packed.size() > size) return std::nullopt;
  switch (compression) {
    case ExrCompression::kNone:
      return std::nullopt;
    case ExrCompression::kRle: {
      const auto bytes = undo_runs(packed, size);
      if (!bytes) return std::nullopt;
      return undo_differences(*bytes);
    }
    case ExrCompression::kZips:
    case ExrCompression::kZip: {
      const auto bytes = inflate_exr(packed, size);
      if (!bytes) return std::nullopt;
      return undo_differences(*bytes);
    }
    case ExrCompression::kPiz:
      return undo_piz(packed, chunk);
    case ExrCompression::kPxr24:
      return undo_pxr24(packed, chunk);
    case ExrCompression::kB44:
    case ExrCompression::kB44a:
      return undo_b44(packed, chunk);
  }
  return std::nullopt;
}

}  // namespace glassbox
