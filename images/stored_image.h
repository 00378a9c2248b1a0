// An image exactly as its file stores it: for comparisons, where reading must not round anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/image.h>

namespace glassbox {

// The samples of pixel (x, y) start at channels * (y * width + x): row by row from the top, the
// channels of a pixel together.
struct StoredImage {
  int width = 0;     // px
  int height = 0;    // px
  int channels = 0;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;

  std::size_t pixels() const { return std::size_t(width) * std::size_t(height); }
  friend bool operator==(const StoredImage&, const StoredImage&) = default;
};

// Returns "8 bits", "16 bits" or "32-bit floats".
std::string format_name(const StoredImage& image);
// Returns "grey", "grey and alpha", "RGB" or "RGBA".
std::string channel_names(const StoredImage& image);

// The properties that a file's header states.
struct StoredHeader {
  int width = 0, height = 0;  // in px
  int channels = 0;           // as in StoredImage
};

// The limit for comparisons: 2^28 pixels, such as 16384 x 16384. All channels of an OpenEXR file
// may have 16 bytes for each of these pixels, 4 GiB.
inline constexpr DecodeLimits kCompareLimits{.max_pixels = std::uint64_t(1) << 28};

// Reads PNG, JPEG, BMP, TGA, PBM, PGM, PPM, PAM, PFM, Radiance HDR or OpenEXR, recognised by the
// content. Palettes and samples of 1, 2 or 4 bits become the 8-bit colours or greys that they
// encode, tRNS becomes alpha; the samples of PGM, PPM or PAM whose largest value is neither 255 nor
// 65535 become the nearest 8-bit or 16-bit values. The pixels of HDR, which share an exponent,
// become the floats that they encode, and so do the halves of OpenEXR. A JPEG is turned as its Exif
// orientation says. Nothing else is converted. The errors are those of decode_image.
Result<StoredImage> decode_stored(std::span<const std::byte> bytes,
                                  const DecodeLimits& limits = kCompareLimits);
Result<StoredImage> read_stored(const std::string& path,
                                const DecodeLimits& limits = kCompareLimits);

// Reads only the header. Gives the errors of decode_stored, except those that only decoding finds.
Result<StoredHeader> stored_header(std::span<const std::byte> bytes,
                                   const DecodeLimits& limits = kCompareLimits);

// The image as encode_png and encode_pfm store it: RGB where every alpha is 255, otherwise RGBA.
StoredImage as_stored(const Image<Rgba8>& image);
StoredImage as_stored(const Image<float>& image);
StoredImage as_stored(const Image<Rgb32f>& image);

}  // namespace glassbox
