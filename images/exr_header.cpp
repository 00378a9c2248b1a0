#include <glassbox/images/exr_header.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <glassbox/base/counted.h>
#include <glassbox/images/byte_order.h>
#include <glassbox/images/image_size.h>
#include <glassbox/images/inflate.h>

// The format is that of "The OpenEXR File Layout" (openexr.com).
namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kMagicBytes = 4, kVersionBytes = 4;
// The low byte of the version is its number, and the other bits are flags.
constexpr std::uint64_t kTilesFlag = 0x200, kLongNamesFlag = 0x400, kDeepFlag = 0x800,
                        kPartsFlag = 0x1000;

tl::unexpected<Error> refuse_exr(const std::string& what, std::string remedy) {
  return fail("", "OpenEXR " + what + ", which is not read", std::move(remedy));
}
tl::unexpected<Error> broken_header() {
  return fail("", "not a valid OpenEXR image: its header is cut off or broken",
              "save the image again");
}

// Removes a text and the zero that ends it from the front.
std::optional<std::string_view> take_text(Bytes& rest) {
  const auto end = std::ranges::find(rest, std::byte{0});
  if (end == rest.end()) return std::nullopt;
  const auto length = std::size_t(end - rest.begin());
  const std::string_view text(reinterpret_cast<const char*>(rest.data()), length);
  rest = rest.subspan(length + 1);
  return text;
}

struct ExrAttribute {
  std::string_view name, type;
  Bytes value;
};

// Removes one attribute from the front: its name, its type, the length of its value, its value.
std::optional<ExrAttribute> take_attribute(Bytes& rest) {
  constexpr std::size_t kLengthBytes = 4;
  const auto name = take_text(rest);
  const auto type = name ? take_text(rest) : std::nullopt;
  if (!type || rest.size() < kLengthBytes) return std::nullopt;
  const std::uint64_t length = little_endian_at(rest, 0, kLengthBytes);
  rest = rest.subspan(kLengthBytes);
  if (rest.size() < length) return std::nullopt;
  const Bytes value = rest.first(length);
  rest = rest.subspan(length);
  return ExrAttribute{*name, *type, value};
}

// The attributes that are read. A value is empty where the header lacks it or has another type.
struct ExrValues {
  Bytes channels, compression, data, display, tiles;
  std::size_t end = 0;  // bytes up to the end of the header
};

// Reads all attributes up to the zero that ends the header.
std::optional<ExrValues> find_values(Bytes bytes) {
  ExrValues values;
  Bytes rest = bytes.subspan(kMagicBytes + kVersionBytes);
  while (!rest.empty() && rest[0] != std::byte{0}) {
    const auto attribute = take_attribute(rest);
    if (!attribute) return std::nullopt;
    const auto keep = [&](std::string_view name, std::string_view type, Bytes& value) {
      if (attribute->name == name && attribute->type == type) value = attribute->value;
    };
    keep("channels", "chlist", values.channels);
    keep("compression", "compression", values.compression);
    keep("dataWindow", "box2i", values.data);
    keep("displayWindow", "box2i", values.display);
    keep("tiles", "tiledesc", values.tiles);
  }
  if (rest.empty()) return std::nullopt;
  values.end = bytes.size() - rest.size() + 1;
  return values;
}

std::optional<ExrWindow> window_of(Bytes value) {
  if (value.size() != 16) return std::nullopt;
  const auto number = [&](std::size_t i) {
    return std::int32_t(little_endian_at(value, 4 * i, 4));
  };
  return ExrWindow{number(0), number(1), number(2), number(3)};
}

// Reads the channels: a name; the type; whether it is perceptual, and three bytes that mean
// nothing; the distances of the samples in x and in y. A zero ends the list.
Result<std::vector<ExrChannel>> channels_of(Bytes rest) {
  constexpr std::size_t kBytesBehindName = 16;
  std::vector<ExrChannel> channels;
  while (!rest.empty() && rest[0] != std::byte{0}) {
    const auto name = take_text(rest);
    if (!name || rest.size() < kBytesBehindName) return broken_header();
    const std::uint64_t type = little_endian_at(rest, 0, 4);
    if (type > std::uint64_t(ExrType::kFloat)) return broken_header();
    if (little_endian_at(rest, 8, 4) != 1 || little_endian_at(rest, 12, 4) != 1) {
      return refuse_exr("with channels of a lower resolution", "save the image as RGB");
    }
    channels.push_back({*name, ExrType(type), rest[4] != std::byte{0}});
    rest = rest.subspan(kBytesBehindName);
  }
  std::ranges::sort(channels, {}, &ExrChannel::name);
  const bool has_double =
      std::ranges::adjacent_find(channels, {}, &ExrChannel::name) != channels.end();
  if (channels.empty() || has_double) return broken_header();
  return channels;
}

Result<ExrCompression> compression_of(Bytes value, const std::vector<ExrChannel>& channels) {
  constexpr const char* kToZip =
      "save it with ZIP compression, for example with oiiotool --compression zip";
  if (value.size() != 1) return broken_header();
  const auto number = std::uint8_t(value[0]);
  if (number == 8 || number == 9) return refuse_exr("with DWA compression", kToZip);
  if (number > std::uint8_t(ExrCompression::kB44a)) {
    return refuse_exr("with an unknown compression", kToZip);
  }
  const auto compression = ExrCompression(number);
  const bool is_b44 = compression == ExrCompression::kB44 || compression == ExrCompression::kB44a;
  const auto is_logarithm = [](const ExrChannel& channel) {
    return channel.type == ExrType::kHalf && channel.is_perceptual;
  };
  if (is_b44 && std::ranges::any_of(channels, is_logarithm)) {
    return refuse_exr("with B44 compression of logarithms", kToZip);
  }
  return compression;
}

int rows_of_chunk(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::kZip:
    case ExrCompression::kPxr24:
      return 16;
    case ExrCompression::kPiz:
    case ExrCompression::kB44:
    case ExrCompression::kB44a:
      return 32;
    default:
      return 1;
  }
}

// Sets the size of a tile: its width, its height, and a byte whose low half is the kind of levels.
Result<void> set_tile_size(Bytes value, ExrHeader& header) {
  if (value.size() != 9) return broken_header();
  const std::uint64_t width = little_endian_at(value, 0, 4), height = little_endian_at(value, 4, 4);
  if (width == 0 || height == 0) return broken_header();
  if ((value[8] & std::byte{15}) != std::byte{0}) {
    return refuse_exr("with several levels of detail",
                      "save the image with one level, for example with exrmaketiled -o");
  }
  // A tile that is larger than the picture holds the picture.
  header.chunk_width = int(std::min(width, std::uint64_t(header.width())));
  header.chunk_height = int(std::min(height, std::uint64_t(header.height())));
  return {};
}

// Refuses kinds of files that are not read, by the flags of the version.
Result<void> check_version(std::uint64_t version) {
  if (version & kDeepFlag) {
    return refuse_exr("with deep pixels", "flatten it, for example with oiiotool --flatten");
  }
  if (version & kPartsFlag) {
    return refuse_exr("with several parts",
                      "save each part as a file, for example with exrmultipart -separate");
  }
  if ((version & ~(kTilesFlag | kLongNamesFlag)) != 2) return broken_header();
  return {};
}

// Whether a window has pixels, and no coordinate that OpenEXR's library refuses as too far away.
bool is_possible(const ExrWindow& window) {
  constexpr std::int32_t kFarthest = std::numeric_limits<std::int32_t>::max() / 2;
  return window.width() > 0 && window.height() > 0 && window.left > -kFarthest &&
         window.top > -kFarthest && window.right < kFarthest && window.bottom < kFarthest;
}

// Checks the bytes of all samples: a file of many channels takes much memory for few pixels.
Result<void> check_sample_bytes(std::uint64_t width, std::uint64_t height,
                                const std::vector<ExrChannel>& channels,
                                const DecodeLimits& limits) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t most_bytes =
      limits.max_pixels > kMost / kWidestPixelBytes ? kMost : limits.max_pixels * kWidestPixelBytes;
  const std::size_t pixel_bytes = exr_pixel_bytes(channels);
  if (width * height <= most_bytes / pixel_bytes) return {};
  return fail(
      "",
      fmt::format("the image has {} x {} pixels of {} bytes in {}, but all samples may have "
                  "at most {} bytes",
                  width, height, pixel_bytes, counted(channels.size(), "channel"), most_bytes),
      "save fewer channels in a file, or scale the image down");
}

// Checks a size before it is an int. Returns an error if so many pixels cannot fit into the file.
Result<void> check_window(const ExrWindow& data, const std::vector<ExrChannel>& channels,
                          std::size_t file_bytes, const DecodeLimits& limits) {
  // One byte of deflate encodes at most kDeflateMaxRatio bytes, and PXR24 leaves out every fourth
  // byte of a float. The other compressions that are read encode less.
  constexpr std::uint64_t kMostSampleBytes = kDeflateMaxRatio * 4 / 3;
  const auto side = [](std::int64_t length) {
    return std::uint64_t(std::max<std::int64_t>(length, 0));
  };
  const std::uint64_t width = side(data.width()), height = side(data.height());
  if (auto sound = check_image_size(width, height, file_bytes, kMostSampleBytes, limits); !sound) {
    return sound;
  }
  if (auto sound = check_sample_bytes(width, height, channels, limits); !sound) {
    return sound;
  }
  const std::size_t pixel_bytes = exr_pixel_bytes(channels);
  if (width * height / kMostSampleBytes > file_bytes / pixel_bytes) {
    return fail("",
                fmt::format("an image of {} x {} pixels of {} bytes cannot fit into {} bytes",
                            width, height, pixel_bytes, file_bytes),
                "the file is cut off, or its width or height is wrong: save the image again");
  }
  return {};
}

}  // namespace

std::size_t exr_pixel_bytes(std::span<const ExrChannel> channels) {
  std::size_t bytes = 0;
  for (const ExrChannel& channel : channels) bytes += channel.bytes();
  return bytes;
}

Result<ExrHeader> read_exr_header(Bytes bytes, const DecodeLimits& limits) {
  const auto error = [](const auto& result) { return tl::unexpected<Error>(result.error()); };
  if (bytes.size() < kMagicBytes + kVersionBytes) return broken_header();
  const std::uint64_t version = little_endian_at(bytes, kMagicBytes, kVersionBytes);
  if (const auto known = check_version(version); !known) return error(known);
  const auto values = find_values(bytes);
  if (!values) return broken_header();
  const auto data = window_of(values->data), display = window_of(values->display);
  if (!data || !display) return broken_header();
  ExrHeader header;
  header.data = *data;
  header.display = *display;
  header.end = values->end;
  auto channels = channels_of(values->channels);
  if (!channels) return error(channels);
  header.channels = std::move(*channels);
  const auto compression = compression_of(values->compression, header.channels);
  if (!compression) return error(compression);
  header.compression = *compression;
  if (const auto sound = check_window(*data, header.channels, bytes.size(), limits); !sound) {
    return error(sound);
  }
  if (!is_possible(*data) || !is_possible(*display)) return broken_header();

  header.has_tiles = (version & kTilesFlag) != 0;
  header.chunk_width = header.width();
  header.chunk_height = std::min(rows_of_chunk(header.compression), header.height());
  if (header.has_tiles) {
    if (const auto sound = set_tile_size(values->tiles, header); !sound) return error(sound);
  }
  return header;
}

}  // namespace glassbox
