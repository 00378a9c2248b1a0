#include <glassbox/images/stored_image.h>

#include <cstring>
#include <utility>

#include <glassbox/images/format.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/pack.h>
#include <glassbox/images/png_read.h>
#include <glassbox/images/pnm.h>
#include <glassbox/images/stb_read.h>

namespace glassbox {
namespace {

tl::unexpected<Error> is_empty() {
  return fail("", "the image is empty", "save the image again");
}
// Calls the reader of the format: with_png, with_pnm or with_pfm, or with_stb of one of its
// formats.
template <class Value>
Result<Value> read_any(std::span<const std::byte> bytes, auto with_png, auto with_pnm,
                       auto with_pfm, auto with_stb) {
  if (bytes.empty()) return is_empty();
  const auto format = picture_format_of(bytes);
  if (!format && is_tga(bytes)) return with_stb(StbFormat::kTga);
  if (!format) return refuse_unknown();
  switch (format->format) {
    case PictureFormat::kPng:
      return with_png();
    case PictureFormat::kJpeg:
      return with_stb(StbFormat::kJpeg);
    case PictureFormat::kBmp:
      return with_stb(StbFormat::kBmp);
    case PictureFormat::kHdr:
      return with_stb(StbFormat::kHdr);
    case PictureFormat::kPnm:
      return with_pnm();
    case PictureFormat::kPfm:
      return with_pfm();
    case PictureFormat::kNotRead:
      break;
  }
  return refuse_format(*format);
}

Result<StoredImage> decode_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return read_any<StoredImage>(
      bytes, [&] { return decode_png_stored(bytes, limits); },
      [&] { return decode_pnm_stored(bytes, limits); },
      [&] { return decode_pfm_stored(bytes, limits); },
      [&](StbFormat format) { return decode_stored_with_stb(format, bytes, limits); });
}

Result<StoredHeader> header_of_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return read_any<StoredHeader>(
      bytes, [&] { return stored_header_of_png(bytes, limits); },
      [&] { return stored_header_of_pnm(bytes, limits); },
      [&] { return stored_header_of_pfm(bytes, limits); },
      [&](StbFormat format) { return stored_header_with_stb(format, bytes, limits); });
}

template <class Pixel>
std::vector<float> floats_of(const Image<Pixel>& image) {
  std::vector<float> samples(image.pixels.size() * sizeof(Pixel) / sizeof(float));
  // The samples are copied as bytes, so that no NaN changes.
  if (!samples.empty()) {
    std::memcpy(samples.data(), image.pixels.data(), samples.size() * sizeof(float));
  }
  return samples;
}

}  // namespace

std::string format_name(const StoredImage& image) {
  constexpr const char* kNames[] = {"8 bits", "16 bits", "32-bit floats"};
  return kNames[image.samples.index()];
}

std::string channel_names(const StoredImage& image) {
  switch (image.channels) {
    case 1:
      return "grey";
    case 2:
      return "grey and alpha";
    case 3:
      return "RGB";
    case 4:
      return "RGBA";
    default:
      return std::to_string(image.channels) + " channels";
  }
}

Result<StoredImage> decode_stored(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return decode_any(bytes, limits); });
}

Result<StoredHeader> stored_header(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return header_of_any(bytes, limits); });
}

StoredImage as_stored(const Image<Rgba8>& image) {
  const int channels = is_opaque(image) ? 3 : 4;
  std::vector<std::uint8_t> samples(image.pixels.size() * std::size_t(channels));
  pack_channels(image.pixels, channels, samples.data());
  return {image.width, image.height, channels, std::move(samples)};
}
StoredImage as_stored(const Image<float>& image) {
  return {image.width, image.height, 1, floats_of(image)};
}
StoredImage as_stored(const Image<Rgb32f>& image) {
  return {image.width, image.height, 3, floats_of(image)};
}

}  // namespace glassbox
