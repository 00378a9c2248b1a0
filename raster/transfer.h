// Conversion between stored bytes and linear light.
#pragma once

#include <glassbox/images/srgb.h>

namespace glassbox {

// kSrgb: bytes are sRGB-encoded. kNone: bytes are linear (byte / 255), for comparisons with
// renderers that do not encode.
enum class Transfer { kSrgb, kNone };

inline float decode(Transfer transfer, std::uint8_t stored) {
  return transfer == Transfer::kSrgb ? decode_srgb(stored) : decode_unorm8(stored);
}
inline std::uint8_t encode(Transfer transfer, float linear) {
  return transfer == Transfer::kSrgb ? encode_srgb(linear) : encode_unorm8(linear);
}

}  // namespace glassbox
