// The timed reciprocals and perspective divisions (D-4, D-5), vectorized with the processor's own
// instructions.
#pragma once

#include <cstdint>
#include <span>

namespace glassbox::study {

enum class Reciprocal {
  kDivide,           // 1/w
  kApproximate,      // the processor's approximate reciprocal
  kNewton,           // kApproximate and one step of Newton's method
  kRootDivide,       // 1/sqrt(w) by square root and division
  kRootApproximate,  // the processor's approximate reciprocal square root
  kRootNewton,
  kMagic,  // 0x5f3759df, see magic_reciprocal_root()
  kMagicNewton,
};

// `out` must be as long as `w`; the length must be a multiple of 64.
void reciprocals(Reciprocal method, std::span<const float> w, std::span<float> out);

enum class Perspective { kDivide, kNewton, kApproximate, kEvery8, kEvery16, kEvery32, kAffine };

inline constexpr int kLinePixels = 256;

// A line of pixels across a surface: the texture coordinate u and 1/w at its two ends.
struct PerspectiveLine {
  float u0 = 0, u1 = 0, inverse_w0 = 1, inverse_w1 = 1;
  int pixels = kLinePixels;  // 1 .. kLinePixels
};

// Looks up texel floor(u), 0 .. kLinePixels - 1, for each pixel centre of each line. Line k is
// written from out[k * kLinePixels] on, one value per pixel; values after that, up to a multiple of
// 8, are meaningless.
void draw_lines(Perspective method, std::span<const PerspectiveLine> lines,
                std::span<const std::int32_t> texture, std::span<std::int32_t> out);

}  // namespace glassbox::study
