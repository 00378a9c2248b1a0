// The size check that every decoder makes before it allocates pixels.
#pragma once

#include <cstdint>

#include <glassbox/images/decode.h>

namespace glassbox {

// The bytes of the widest pixel of a picture: four floats.
inline constexpr std::uint64_t kWidestPixelBytes = 4 * sizeof(float);

// Refuses a size of zero, a size above the limits, and a size of more pixels than `bytes` bytes can
// hold with `pixels_per_byte` pixels each.
Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t bytes,
                              std::uint64_t pixels_per_byte, const DecodeLimits& limits);

}  // namespace glassbox
