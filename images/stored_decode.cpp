#include <glassbox/images/exr_read.h>
#include <glassbox/images/format.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/png_read.h>
#include <glassbox/images/pnm.h>
#include <glassbox/images/stb_read.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {
namespace {

tl::unexpected<Error> is_empty() {
  return fail("", "the image is empty", "save the image again");
}

// Calls the reader of the format: with_png, with_pnm, with_pfm or with_exr, or with_stb of one of
// its formats.
template <class Value>
Result<Value> read_any(std::span<const std::byte> bytes, auto with_png, auto with_pnm,
                       auto with_pfm, auto with_exr, auto with_stb) {
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
    case PictureFormat::kExr:
      return with_exr();
    case PictureFormat::kNotRead:
      break;
  }
  return refuse_format(*format);
}

Result<StoredImage> decode_any_stored(std::span<const std::byte> bytes,
                                      const DecodeLimits& limits) {
  return read_any<StoredImage>(
      bytes, [&] { return decode_png_stored(bytes, limits); },
      [&] { return decode_pnm_stored(bytes, limits); },
      [&] { return decode_pfm_stored(bytes, limits); },
      [&] { return decode_exr_stored(bytes, limits); },
      [&](StbFormat format) { return decode_stored_with_stb(format, bytes, limits); });
}

Result<StoredHeader> header_of_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return read_any<StoredHeader>(
      bytes, [&] { return stored_header_of_png(bytes, limits); },
      [&] { return stored_header_of_pnm(bytes, limits); },
      [&] { return stored_header_of_pfm(bytes, limits); },
      [&] { return stored_header_of_exr(bytes, limits); },
      [&](StbFormat format) { return stored_header_with_stb(format, bytes, limits); });
}

}  // namespace

Result<StoredImage> decode_stored(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return decode_any_stored(bytes, limits); });
}

Result<StoredHeader> stored_header(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return header_of_any(bytes, limits); });
}

}  // namespace glassbox
