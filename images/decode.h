// Image files in memory to pixels: PNG, JPEG, BMP and TGA, from files that are hostile until proved otherwise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// What an image may ask for. The default of 2^26 pixels decodes into 256 MiB at most.
struct DecodeLimits {
  std::uint64_t max_pixels = std::uint64_t(1) << 26;
  std::uint32_t max_side = 16384;  // px
};

// The pixels of an image file, as stored: grey becomes r = g = b, a missing alpha becomes 255, and 16 bits a channel
// become the nearest 8. The header is checked against the limits and against the number of bytes that follow it (a
// file too short for the size it claims is refused) before anything is allocated in proportion to it.
Result<Image<Rgba8>> decode_image(std::span<const std::byte> bytes,
                                  const DecodeLimits& limits = {});

struct ImageSize {
  std::uint32_t width = 0, height = 0;  // px
};

// What the header of such a file says. Nothing is decoded, and what follows the header is not looked at where the size can
// be told without.
std::optional<ImageSize> find_image_size(std::span<const std::byte> bytes);

}  // namespace glassbox
