#include <glassbox/images/decode.h>

#include <limits>
#include <string>

#include <glassbox/images/byte_order.h>
#include <glassbox/images/format.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/png_read.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stb_read.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

namespace {

Result<Image<Rgba8>> decode_any(std::span<const std::byte> bytes, const DecodeLimits& limits,
                                Orientation orientation) {
  if (bytes.empty()) return fail("", "the image is empty", "save the image again");
  const auto format = picture_format_of(bytes);
  if (!format && is_tga(bytes)) return decode_with_stb(StbFormat::kTga, bytes, limits, orientation);
  if (!format) return refuse_unknown();
  switch (format->format) {
    case PictureFormat::kPng:
      return decode_png(bytes, limits);
    case PictureFormat::kJpeg:
      return decode_with_stb(StbFormat::kJpeg, bytes, limits, orientation);
    case PictureFormat::kBmp:
      return decode_with_stb(StbFormat::kBmp, bytes, limits, orientation);
    case PictureFormat::kPnm:
      return decode_pnm(bytes, limits);
    case PictureFormat::kPfm:
    case PictureFormat::kHdr:
    case PictureFormat::kExr:
      return fail(
          "", "is a " + std::string(format->name) + " picture, whose floats cannot be used here",
          "convert it to PNG");
    case PictureFormat::kNotRead:
      break;
  }
  return refuse_format(*format);
}

// Reads the size from the start of a PNG file: its signature, the length and name of the first
// chunk, then width and height, most significant byte first.
std::optional<ImageSize> png_size(std::span<const std::byte> bytes) {
  constexpr std::size_t kWidth = 16, kHeight = 20, kEnd = 24;
  if (bytes.size() < kEnd) return std::nullopt;
  return ImageSize{big_endian_at(bytes, kWidth), big_endian_at(bytes, kHeight)};
}

}  // namespace

std::optional<ImageSize> find_image_size(std::span<const std::byte> bytes) {
  if (is_png(bytes)) return png_size(bytes);
  constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
  const auto header = stored_header(bytes, {kAll, std::numeric_limits<std::uint32_t>::max()});
  if (!header) return std::nullopt;
  return ImageSize{std::uint32_t(header->width), std::uint32_t(header->height)};
}

Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes, const DecodeLimits& limits,
                                  Orientation orientation) {
  return unless_out_of_memory([&] { return decode_any(bytes, limits, orientation); });
}

}  // namespace glassbox
