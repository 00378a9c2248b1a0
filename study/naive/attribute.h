// Wrong ways to interpolate attributes over a triangle, and to wrap texture coordinates.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <glassbox/mesh/scene.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/stages.h>

namespace glassbox::study::naive {

// ---- over a triangle ----

// Interpolates linearly on the screen, which ignores perspective.
inline float affine(const TriangleSetup& t, const Coverage& pixel, const std::array<float, 3>& a) {
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += float(pixel.edges[k]) * t.inverse_area * a[k];
  return sum;
}

// The reciprocal with the accuracy of the SSE instruction rcpss: a relative error of up to 1.5 *
// 2^-12, about 12 bits. Here the other bits are cut off, so that the result is the same on every
// machine.
inline float raw_reciprocal(float x) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f / x) & 0xfffff000u);
}

inline float over_w(const TriangleSetup& t, const Coverage& pixel, const std::array<float, 3>& a) {
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += float(pixel.edges[k]) * t.inverse_area * t.inverse_w[k] * a[k];
  }
  return sum;
}
// The right formula (the sum of a/w divided by the sum of 1/w), but with a reciprocal that has only
// half of a float's bits.
inline float with_raw_reciprocal(const TriangleSetup& t, const Coverage& pixel,
                                 const std::array<float, 3>& a) {
  return over_w(t, pixel, a) * raw_reciprocal(over_w(t, pixel, {1, 1, 1}));
}
// Multiplies by a w that is interpolated linearly, which is wrong: only 1/w and the attribute
// divided by w are linear on the screen.
inline float with_linear_w(const TriangleSetup& t, const Coverage& pixel,
                           const std::array<float, 3>& a) {
  return over_w(t, pixel, a) *
         affine(t, pixel, {1 / t.inverse_w[0], 1 / t.inverse_w[1], 1 / t.inverse_w[2]});
}

// ---- texels along one axis ----

// Scales the coordinate first, to a 32-bit integer that overflows for large coordinates. Then takes
// the remainder as C does, which is negative for negative numbers, and drops its sign.
inline int scaled_then_wrapped(Wrap, float t, int size) {
  const auto scaled = std::int32_t(std::uint32_t(std::int64_t(double(t) * size)));
  return std::abs(scaled % size);
}
// The right order of steps (subtracts the whole part, then scales), but truncates towards zero
// instead of rounding down.
inline int truncated(Wrap wrap, float t, int size) {
  if (wrap == Wrap::kClampToEdge) return t < 0 ? 0 : t >= 1 ? size - 1 : int(t * float(size));
  const float whole = wrap == Wrap::kRepeat ? std::trunc(t) : 2 * std::trunc(t * 0.5f);
  const int texel = std::abs(int((t - whole) * float(size)));
  return texel < size ? texel : 2 * size - 1 - texel;
}
// Scales in float before it subtracts the whole part: far from coordinate 0, floats are so coarse
// that neighbouring texels become the same.
inline int scaled_in_float(Wrap, float t, int size) {
  const float scaled = t * float(size) + 0.25f;
  const float whole = float(size) * std::floor(scaled / float(size));
  const int texel = int(std::floor(scaled - whole));
  return texel < 0 ? 0 : texel >= size ? size - 1 : texel;
}
// Mirrors the texture about the centres of its outermost texels, which then appear once at each
// mirror instead of twice.
inline int mirrored_about_texels(Wrap wrap, float t, int size) {
  const int texel = int(std::floor(t * float(size)));
  const auto modulo = [](int n, int m) { return ((n % m) + m) % m; };
  if (wrap == Wrap::kRepeat) return modulo(texel, size);
  if (wrap == Wrap::kClampToEdge) return texel < 0 ? 0 : texel >= size ? size - 1 : texel;
  const int folded = modulo(texel, 2 * size - 2);
  return folded < size ? folded : 2 * size - 2 - folded;
}

}  // namespace glassbox::study::naive
