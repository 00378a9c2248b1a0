// The format of a picture file, told from its first bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <glassbox/base/error.h>

namespace glassbox {

enum class PictureFormat : std::uint8_t {
  kPng,
  kJpeg,
  kBmp,
  kPnm,      // PBM, PGM, PPM (P1 to P6) and PAM (P7)
  kPfm,      // floats
  kHdr,      // Radiance, floats
  kExr,      // OpenEXR, floats
  kNotRead,  // a format that is known by name alone
};

struct NamedFormat {
  PictureFormat format;
  std::string_view name;  // "TIFF"
};

// The length of the longest beginning that picture_format_of looks at.
inline constexpr std::size_t kFormatBytes = 12;

// None for bytes that begin like no known format. TGA files have no signature, so they are among
// these.
std::optional<NamedFormat> picture_format_of(std::span<const std::byte> bytes);

// Refuses a file of a format that is known, but not read here.
tl::unexpected<Error> refuse_format(const NamedFormat& format);

// Refuses a file of no known format.
tl::unexpected<Error> refuse_unknown();

// Whether names with this extension (".png", in upper or lower case) are those of pictures. Formats
// that are not read are among them.
bool is_picture_extension(std::string_view extension);

}  // namespace glassbox
