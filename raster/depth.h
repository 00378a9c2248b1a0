// Decides which of two fragments is in front. Every format stores depth as a 32-bit code; the
// smaller code is nearer.
#pragma once

#include <cstdint>

#include <glassbox/raster/formulas.h>

namespace glassbox {

// kFloat32Reversed expects a view with DepthRange::kReversed, where depth 1 is near.
enum class DepthFormat { kFloat32, kFloat32Reversed, kUnorm24, kUnorm16 };

// The code of an empty depth buffer. It is behind every possible depth, the far plane's included.
// (Clearing to depth 1 would lose surfaces exactly on the far plane, and with an infinite far plane
// everything that rounds to it.)
inline constexpr std::uint32_t kEmptyDepth = 0xffffffffu;

// The code of depth 1 in a format of unsigned integers.
inline double unorm_depth_steps(DepthFormat format) {
  return format == DepthFormat::kUnorm24 ? 0xffffff : 0xffff;
}

// Returns the code of a depth, which is clamped to [0, 1].
inline std::uint32_t depth_code(DepthFormat format, float depth) {
  switch (format) {
    case DepthFormat::kFloat32:
      return std::uint32_t(float_depth_code(depth));
    case DepthFormat::kFloat32Reversed:
      return std::uint32_t(reversed_depth_code(depth));
    case DepthFormat::kUnorm24:
    case DepthFormat::kUnorm16:
      return std::uint32_t(unorm_depth_code(depth, unorm_depth_steps(format)));
  }
  return kEmptyDepth;
}

// Strictly smaller, so that of two equal depths the one drawn first stays.
inline bool in_front(std::uint32_t incoming, std::uint32_t stored) {
  return incoming < stored;
}

}  // namespace glassbox
