// Decodes image files in memory: PNG, JPEG, BMP, TGA, PBM, PGM, PPM and PAM. The files may be
// hostile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// The largest image that is decoded. The default of 2^26 pixels decodes into 256 MiB at most.
struct DecodeLimits {
  std::uint64_t max_pixels = std::uint64_t(1) << 26;
  std::uint32_t max_side = 16384;  // px
};

// What becomes of the orientation in the Exif data of a JPEG.
enum class Orientation : std::uint8_t {
  kUpright,  // the picture is turned, as viewers show it
  kStored,   // the rows stay as they are stored
};

// Returns the pixels of an image file: grey becomes r = g = b, a missing alpha becomes 255, and 16
// bits a channel are rounded to the nearest 8-bit value. Floats (PFM, HDR, EXR) are refused. The
// first frame of an animation is read. Before anything is allocated
// in proportion to the size in the header, this size is checked against the limits and against the
// number of bytes that follow (a file too short for the size that it claims is refused).
Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes, const DecodeLimits& limits = {},
                                  Orientation orientation = Orientation::kUpright);

struct ImageSize {
  std::uint32_t width = 0, height = 0;  // px
};

// Returns the size that the header of an image file states, upright. Nothing is decoded, and the
// bytes after the header are not read where the size can be found without them.
std::optional<ImageSize> find_image_size(std::span<const std::byte> bytes);

}  // namespace glassbox
