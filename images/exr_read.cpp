#include <glassbox/images/exr_read.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <glassbox/base/counted.h>
#include <glassbox/images/byte_order.h>
#include <glassbox/images/exr_header.h>
#include <glassbox/images/exr_unpack.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

// ---- the picture among the channels ----

struct ExrPicture {
  ExrHeader header;
  int channels = 0;           // of the picture
  std::vector<int> shown_as;  // for each channel of the file: that of the picture, or -1
};

// Returns for each channel of the file its place among the picture's, or -1. Returns none if the
// file lacks one of them; only A may be missing, which is the last one.
std::vector<int> places_of(const std::vector<ExrChannel>& channels,
                           std::span<const std::string_view> picture) {
  std::vector<int> places;
  std::size_t found = 0;  // without A
  for (const ExrChannel& channel : channels) {
    const auto at = std::ranges::find(picture, channel.name);
    places.push_back(at == picture.end() ? -1 : int(at - picture.begin()));
    found += at != picture.end() && channel.name != "A" ? 1u : 0u;
  }
  return found + 1 == picture.size() ? places : std::vector<int>();
}

Result<ExrPicture> find_picture(Result<ExrHeader> read) {
  static constexpr std::array<std::string_view, 4> kColour{"R", "G", "B", "A"};
  static constexpr std::array<std::string_view, 2> kGrey{"Y", "A"};
  if (!read) return tl::unexpected<Error>(read.error());
  ExrPicture picture{.header = std::move(*read), .channels = 0, .shown_as = {}};
  const auto& channels = picture.header.channels;
  picture.shown_as = places_of(channels, kColour);
  if (picture.shown_as.empty()) picture.shown_as = places_of(channels, kGrey);
  if (picture.shown_as.empty() && channels.size() == 1) picture.shown_as = {0};
  if (picture.shown_as.empty()) {
    return fail("", "OpenEXR without channels named R, G and B, or Y",
                "save the picture in channels of these names");
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (picture.shown_as[i] < 0) continue;
    ++picture.channels;
    if (channels[i].type == ExrType::kUint) {
      return fail("", "OpenEXR with a picture of 32-bit integers, which is not read",
                  "save it with halves or floats");
    }
  }
  return picture;
}

// ---- the samples ----

// Returns the bits of the float that has the value of a half (IEEE 754: binary16, binary32).
std::uint32_t float_bits_of_half(std::uint32_t half) {
  const std::uint32_t sign = (half & 0x8000u) << 16, exponent = half >> 10 & 31u;
  std::uint32_t fraction = half & 0x3ffu;
  if (exponent == 31) return sign | 0x7f800000u | fraction << 13;  // infinity or NaN
  // The exponents have the biases 15 and 127.
  if (exponent > 0) return sign | (exponent + 112) << 23 | fraction << 13;
  if (fraction == 0) return sign;
  // A subnormal half, fraction * 2^-24, is a normal float, whose first bit is not stored.
  std::uint32_t shifts = 0;
  for (; (fraction & 0x400u) == 0; ++shifts) fraction <<= 1;
  return sign | (113 - shifts) << 23 | (fraction & 0x3ffu) << 13;
}

// The samples of the picture, and those of each further channel in turn, row by row. The latter are
// empty where they are left out.
struct ExrSamples {
  std::vector<float> shown;
  std::vector<std::byte> further;
};

enum class Further : std::uint8_t { kKept, kLeftOut };

// Writes the bits of `count` samples to every `stride`-th float.
void show_samples(Bytes stored, ExrType type, float* to, std::size_t stride, std::size_t count) {
  const std::size_t size = type == ExrType::kHalf ? 2 : 4;
  for (std::size_t i = 0; i < count; ++i, to += stride) {
    const auto sample = std::uint32_t(little_endian_at(stored, size * i, size));
    const std::uint32_t bits = size == 2 ? float_bits_of_half(sample) : sample;
    // The bits are copied, so that no NaN changes.
    std::memcpy(to, &bits, sizeof bits);
  }
}

// Where a chunk lies in the picture.
struct ExrPlace {
  std::size_t left = 0, top = 0, width = 0, height = 0;  // px
};

// Distributes the unpacked samples of a chunk.
void distribute(Bytes unpacked, const ExrPicture& picture, const ExrPlace& place,
                ExrSamples& samples) {
  const ExrHeader& header = picture.header;
  const auto stride = std::size_t(picture.channels);
  for (std::size_t y = 0; y < place.height; ++y) {
    const std::size_t pixel = (place.top + y) * std::size_t(header.width()) + place.left;
    std::size_t plane = 0;  // where a further channel begins
    for (std::size_t i = 0; i < header.channels.size(); ++i) {
      const ExrChannel& channel = header.channels[i];
      const Bytes row = unpacked.first(place.width * channel.bytes());
      unpacked = unpacked.subspan(row.size());
      if (picture.shown_as[i] >= 0) {
        float* to = samples.shown.data() + pixel * stride + std::size_t(picture.shown_as[i]);
        show_samples(row, channel.type, to, stride, place.width);
      } else if (!samples.further.empty()) {
        std::ranges::copy(row, samples.further.data() + plane + pixel * channel.bytes());
        plane += header.pixels() * channel.bytes();
      }
    }
  }
}

tl::unexpected<Error> broken_chunk(const ExrPlace& place) {
  return fail("",
              fmt::format("not a valid OpenEXR image: the samples from pixel ({}, {}) on are cut "
                          "off or broken",
                          place.left, place.top),
              "save the image again");
}

// Returns the packed bytes of a chunk. Before them stand its place, which for a tile is its column,
// its row and its level of detail, and the number of its bytes.
Result<Bytes> packed_chunk(Bytes bytes, const ExrHeader& header, std::size_t number,
                           const ExrPlace& place) {
  constexpr std::size_t kOffsetBytes = 8;
  const std::size_t entry = header.end + number * kOffsetBytes;
  if (bytes.size() < kOffsetBytes || entry > bytes.size() - kOffsetBytes) {
    return broken_chunk(place);
  }
  const std::uint64_t offset = little_endian_at(bytes, entry, kOffsetBytes);
  const std::size_t place_bytes = header.has_tiles ? 16 : 4, head_bytes = place_bytes + 4;
  if (offset < header.end || offset > bytes.size() || bytes.size() - offset < head_bytes) {
    return broken_chunk(place);
  }
  const Bytes chunk = bytes.subspan(std::size_t(offset));
  const bool is_there =
      header.has_tiles
          ? little_endian_at(chunk, 0, 4) == place.left / std::size_t(header.chunk_width) &&
                little_endian_at(chunk, 4, 4) == place.top / std::size_t(header.chunk_height) &&
                little_endian_at(chunk, 8, 8) == 0
          : little_endian_at(chunk, 0, 4) == std::uint32_t(header.data.top + int(place.top));
  const std::uint64_t packed = little_endian_at(chunk, place_bytes, 4);
  if (!is_there || packed > chunk.size() - head_bytes) return broken_chunk(place);
  return chunk.subspan(head_bytes, std::size_t(packed));
}

// The bytes that a pixel has in the further channels.
std::size_t further_pixel_bytes(const ExrPicture& picture) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < picture.shown_as.size(); ++i) {
    if (picture.shown_as[i] < 0) bytes += picture.header.channels[i].bytes();
  }
  return bytes;
}

Result<ExrSamples> read_samples(Bytes bytes, const ExrPicture& picture, Further further) {
  const ExrHeader& header = picture.header;
  ExrSamples samples;
  samples.shown.resize(header.pixels() * std::size_t(picture.channels));
  if (further == Further::kKept) {
    samples.further.resize(header.pixels() * further_pixel_bytes(picture));
  }

  const auto width = std::size_t(header.width()), height = std::size_t(header.height());
  const auto chunk_width = std::size_t(header.chunk_width);
  const auto chunk_height = std::size_t(header.chunk_height);
  std::size_t number = 0;
  for (std::size_t top = 0; top < height; top += chunk_height) {
    for (std::size_t left = 0; left < width; left += chunk_width) {
      const ExrPlace place{left, top, std::min(chunk_width, width - left),
                           std::min(chunk_height, height - top)};
      const auto packed = packed_chunk(bytes, header, number++, place);
      if (!packed) return tl::unexpected<Error>(packed.error());
      const auto unpacked =
          unpack_exr(*packed, header.compression, {place.width, place.height, header.channels});
      if (!unpacked) return broken_chunk(place);
      distribute(*unpacked, picture, place, samples);
    }
  }
  return samples;
}

StoredImage image_of(const ExrPicture& picture, std::vector<float> samples) {
  return {picture.header.width(), picture.header.height(), picture.channels, std::move(samples)};
}

// ---- what is not the picture ----

void append_text(std::vector<std::byte>& bytes, std::string_view text) {
  const Bytes more = std::as_bytes(std::span(text));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

// Adds the samples of the further channels, and the channels' names and types.
void add_further_channels(const ExrPicture& picture, std::vector<std::byte> samples,
                          StoredFile& file) {
  const auto& channels = picture.header.channels;
  const std::size_t count = channels.size() - std::size_t(picture.channels);
  if (count == 0) return;
  file.rest = std::move(samples);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (picture.shown_as[i] >= 0) continue;
    append_text(file.rest, channels[i].name);
    append_text(file.rest, fmt::format(" {}\n", int(channels[i].type)));
  }
  file.rest_name = counted(count, "further channel");
}

void add_window(const ExrHeader& header, StoredFile& file) {
  const ExrWindow &data = header.data, &display = header.display;
  if (data == display) return;
  const std::string place =
      fmt::format("a data window at ({}, {}) of a display window of {} x {} pixels",
                  std::int64_t(data.left) - display.left, std::int64_t(data.top) - display.top,
                  display.width(), display.height());
  append_text(file.rest, place);
  file.rest_name += (file.rest_name.empty() ? "" : " and ") + place;
}

void add_rest(const ExrPicture& picture, std::vector<std::byte> further, StoredFile& file) {
  add_further_channels(picture, std::move(further), file);
  add_window(picture.header, file);
  file.rest_remedy =
      "save both with one data window, and their further channels as files of their own";
}

}  // namespace

Result<StoredImage> decode_exr_stored(Bytes bytes, const DecodeLimits& limits) {
  const auto picture = find_picture(read_exr_header(bytes, limits));
  if (!picture) return tl::unexpected<Error>(picture.error());
  return read_samples(bytes, *picture, Further::kLeftOut).map([&](ExrSamples&& samples) {
    return image_of(*picture, std::move(samples.shown));
  });
}

Result<StoredFile> decode_exr_file(Bytes bytes, const DecodeLimits& limits) {
  const auto picture = find_picture(read_exr_header(bytes, limits));
  if (!picture) return tl::unexpected<Error>(picture.error());
  auto samples = read_samples(bytes, *picture, Further::kKept);
  if (!samples) return tl::unexpected<Error>(samples.error());
  StoredFile file;
  file.image = image_of(*picture, std::move(samples->shown));
  add_rest(*picture, std::move(samples->further), file);
  return file;
}

Result<StoredHeader> stored_header_of_exr(Bytes bytes, const DecodeLimits& limits) {
  return find_picture(read_exr_header(bytes, limits)).map([](const ExrPicture& picture) {
    return StoredHeader{picture.header.width(), picture.header.height(), picture.channels};
  });
}

}  // namespace glassbox
