#include <glassbox/images/png_plain.h>

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <glassbox/images/byte_order.h>
#include <glassbox/images/image_size.h>
#include <glassbox/images/inflate.h>
#include <glassbox/images/png_chunks.h>
#include <glassbox/images/png_filters.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

// The picture that an IHDR chunk describes (PNG, third edition, 11.2.1).
struct PlainHeader {
  std::uint32_t width = 0, height = 0;  // px
  std::size_t channels = 0;
  std::size_t bytes_per_sample = 0;  // 1 or 2

  std::size_t pixel_bytes() const { return channels * bytes_per_sample; }
  std::size_t row_bytes() const { return width * pixel_bytes(); }
  std::size_t filtered_bytes() const { return (row_bytes() + 1) * height; }
};

// The parts of a plain file.
struct PlainParts {
  PlainHeader header;
  std::vector<Bytes> data;  // those of the IDAT chunks
};

// The number of channels by IHDR's type of colour; 0 for a palette and for what PNG does not have.
constexpr std::array<std::size_t, 7> kChannelsOfType{1, 0, 3, 0, 2, 0, 4};

std::optional<PlainHeader> plain_header(const PngChunk& chunk, std::size_t file_bytes,
                                        const DecodeLimits& limits) {
  constexpr std::size_t kSize = 13;
  if (chunk.type != "IHDR" || chunk.data.size() != kSize) return {};
  const Bytes bytes = chunk.type_and_data.subspan(chunk.type.size());
  const auto byte = [&](std::size_t at) { return std::to_integer<std::size_t>(bytes[at]); };
  const std::size_t depth = byte(8), type = byte(9);
  const bool has_usual_methods = byte(10) == 0 && byte(11) == 0 && byte(12) == 0;
  if ((depth != 8 && depth != 16) || type >= kChannelsOfType.size() || !has_usual_methods) {
    return {};
  }
  const PlainHeader header{big_endian_at(bytes, 0), big_endian_at(bytes, 4), kChannelsOfType[type],
                           depth / 8};
  if (header.channels == 0) return {};
  const std::uint64_t pixels_per_byte = kDeflateMaxRatio / header.pixel_bytes();
  if (!check_image_size(header.width, header.height, file_bytes, pixels_per_byte, limits))
    return {};
  return header;
}

bool has_right_crc(const PngChunk& chunk) {
  return libdeflate_crc32(0, chunk.type_and_data.data(), chunk.type_and_data.size()) == chunk.crc;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Whether a decoder may skip the chunk: the first letter of its name is a small one, and the third,
// which has no meaning yet, is not. tRNS has pixels' alpha.
bool may_be_skipped(const PngChunk& chunk) {
  const auto is_small = [&](std::size_t i) { return chunk.type[i] >= 'a'; };
  return std::ranges::all_of(chunk.type, is_letter) && is_small(0) && !is_small(2) &&
         chunk.type != "tRNS";
}

// The parts of a file that has IHDR, IDATs one behind the other, IEND, and chunks that may be
// skipped. The rest of a file behind IEND does not belong to the picture.
std::optional<PlainParts> plain_parts(Bytes file, const DecodeLimits& limits) {
  Bytes rest = png_chunks(file);
  const auto first = take_png_chunk(rest);
  if (!first || !has_right_crc(*first)) return {};
  const auto header = plain_header(*first, file.size(), limits);
  if (!header) return {};
  PlainParts parts{*header, {}};
  bool in_data = false;
  while (true) {
    const auto chunk = take_png_chunk(rest);
    if (!chunk) return {};
    const bool is_data = chunk->type == "IDAT", is_end = chunk->type == "IEND";
    const bool is_known = (is_data && (in_data || parts.data.empty())) ||
                          (is_end && chunk->data.empty() && !parts.data.empty());
    if (is_known ? !has_right_crc(*chunk) : !may_be_skipped(*chunk)) return {};
    if (is_end) return parts;
    if (is_data) parts.data.push_back(chunk->type_and_data.subspan(chunk->type.size()));
    in_data = is_data;
  }
}

// Decompresses the data to exactly `target`. Returns whether nothing of them was left over.
bool decompress(Bytes data, std::span<std::uint8_t> target) {
  return has_wide_window(data, target.size()) &&
         inflate_exactly(data, std::as_writable_bytes(target)) == data.size();
}

bool decompress(const std::vector<Bytes>& data, std::span<std::uint8_t> target) {
  if (data.size() == 1) return decompress(data.front(), target);
  std::size_t size = 0;
  for (const Bytes& part : data) size += part.size();
  std::vector<std::byte> joined;
  joined.reserve(size);
  for (const Bytes& part : data) joined.insert(joined.end(), part.begin(), part.end());
  return decompress(Bytes(joined), target);
}

// The samples of 16 bits are big-endian in the file.
void to_native(std::vector<std::uint8_t>&) {}
void to_native(std::vector<std::uint16_t>& samples) {
  if constexpr (std::endian::native == std::endian::big) return;
  for (std::uint16_t& sample : samples) sample = std::uint16_t(sample << 8 | sample >> 8);
}

template <class Sample>
std::optional<StoredImage> decode_samples(const PlainParts& parts) {
  const PlainHeader& header = parts.header;
  // First the vector holds the filter bytes, too.
  std::vector<Sample> samples((header.filtered_bytes() + sizeof(Sample) - 1) / sizeof(Sample));
  const std::span bytes(reinterpret_cast<std::uint8_t*>(samples.data()), header.filtered_bytes());
  if (!decompress(parts.data, bytes) ||
      !undo_png_filters(bytes, header.height, header.row_bytes(), header.pixel_bytes())) {
    return {};
  }
  samples.resize(header.row_bytes() * header.height / sizeof(Sample));
  to_native(samples);
  return StoredImage{int(header.width), int(header.height), int(header.channels),
                     std::move(samples)};
}

}  // namespace

std::optional<StoredImage> decode_plain_png(Bytes bytes, const DecodeLimits& limits) {
  const auto parts = plain_parts(bytes, limits);
  if (!parts) return {};
  return parts->header.bytes_per_sample == 2 ? decode_samples<std::uint16_t>(*parts)
                                             : decode_samples<std::uint8_t>(*parts);
}

}  // namespace glassbox
