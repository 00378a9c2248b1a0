// Which fragment is in front. Every format keeps its depth as a 32-bit code; the smaller code is nearer.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace glassbox {

// kFloat32Reversed expects a view with DepthRange::kReversed, where depth 1 is near.
enum class DepthFormat { kFloat32, kFloat32Reversed, kUnorm24, kUnorm16 };

// What an empty buffer holds: behind every depth there is, the far plane's included. (Clearing to depth 1 would lose
// what lies exactly on the far plane, and with an infinite far plane whatever rounds to it.)
inline constexpr std::uint32_t kEmptyDepth = 0xffffffffu;

// round-half-up of z (2^bits - 1). Exact: 24-bit z times at most 24 bits fits a double, and so does the sum with a half
// wherever it could reach the next integer.
inline std::uint32_t quantise_depth(float z, int bits) {
  const double steps = double((1u << bits) - 1u);
  return std::uint32_t(std::floor(double(z) * steps + 0.5));
}

// Depth outside [0, 1] (rounding at a clipped edge) is clamped. Non-negative floats order as their bits do.
inline std::uint32_t depth_code(DepthFormat format, float depth) {
  const float z = depth > 0.0f ? (depth < 1.0f ? depth : 1.0f) : 0.0f;
  switch (format) {
    case DepthFormat::kFloat32:
      return std::bit_cast<std::uint32_t>(z);
    case DepthFormat::kFloat32Reversed: {
      return std::bit_cast<std::uint32_t>(1.0f) - std::bit_cast<std::uint32_t>(z);
    }
    case DepthFormat::kUnorm24:
      return quantise_depth(z, 24);
    case DepthFormat::kUnorm16:
      return quantise_depth(z, 16);
  }
  return kEmptyDepth;
}

// Strict, so that of two equal depths the first drawn stays.
inline bool in_front(std::uint32_t incoming, std::uint32_t stored) {
  return incoming < stored;
}

}  // namespace glassbox
