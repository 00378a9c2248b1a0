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

}  // namespace

Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return decode_any(bytes, limits); });
}

}  // namespace glassbox
