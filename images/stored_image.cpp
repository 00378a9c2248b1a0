#include <glassbox/images/stored_image.h>

#include <cstring>
#include <utility>

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
tl::unexpected<Error> is_none() {
  return fail("", "not a PNG, JPEG, BMP, TGA, PPM, PGM or PFM image", "convert it to PNG");
}

Result<StoredImage> decode_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  if (bytes.empty()) return is_empty();
  if (is_png(bytes)) return decode_png_stored(bytes, limits);
  if (is_pnm(bytes)) return decode_pnm_stored(bytes, limits);
  if (is_pfm(bytes)) return decode_pfm_stored(bytes, limits);
  if (is_stb_format(bytes)) return decode_stored_with_stb(bytes, limits);
  return is_none();
}

Result<StoredHeader> header_of_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  if (bytes.empty()) return is_empty();
  if (is_png(bytes)) return stored_header_of_png(bytes, limits);
  if (is_pnm(bytes)) return stored_header_of_pnm(bytes, limits);
  if (is_pfm(bytes)) return stored_header_of_pfm(bytes, limits);
  if (is_stb_format(bytes)) return stored_header_with_stb(bytes, limits);
  return is_none();
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
