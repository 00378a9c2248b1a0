// The PNG half of decode.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>

namespace glassbox {

bool is_png(std::span<const std::byte> bytes);
Result<Image<Rgba8>> decode_png(std::span<const std::byte> bytes, const DecodeLimits& limits);

// Refuses sizes of zero, above the limits, or of more pixels than `bytes` bytes can hold at `pixels_per_byte`.
Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t bytes,
                              std::uint64_t pixels_per_byte, const DecodeLimits& limits);

}  // namespace glassbox
