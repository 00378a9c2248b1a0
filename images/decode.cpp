#include <glassbox/images/decode.h>

#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/png_read.h>
#include <glassbox/images/stb_read.h>

namespace glassbox {

namespace {

Result<Image<Rgba8>> decode_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  if (bytes.empty()) return fail("", "the image is empty", "save the image again");
  if (is_png(bytes)) return decode_png(bytes, limits);
  if (is_stb_format(bytes)) return decode_with_stb(bytes, limits);
  return fail("", "not a PNG, JPEG, BMP or TGA image", "convert it to PNG");
}

// Reads the size from the start of a PNG file: its signature, the length and name of the first
// chunk, then width and height, most significant byte first.
std::optional<ImageSize> png_size(std::span<const std::byte> bytes) {
  constexpr std::size_t kWidth = 16, kHeight = 20, kEnd = 24;
  if (bytes.size() < kEnd) return std::nullopt;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(bytes[at + i]);
    return value;
  };
  return ImageSize{number(kWidth), number(kHeight)};
}

}  // namespace

std::optional<ImageSize> find_image_size(std::span<const std::byte> bytes) {
  if (is_png(bytes)) return png_size(bytes);
  return is_stb_format(bytes) ? find_size_with_stb(bytes) : std::nullopt;
}

Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return decode_any(bytes, limits); });
}

}  // namespace glassbox
