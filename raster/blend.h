// The last stage: what is written where.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

// Which channels may be written. An anaglyph's left eye writes red, its right eye green and blue (S0-05).
struct ColorMask {
  bool r = true, g = true, b = true, a = true;
};

inline Rgba8 encode(Transfer transfer, const Rgba& linear) {
  return {encode(transfer, linear.r), encode(transfer, linear.g), encode(transfer, linear.b),
          encode_unorm8(linear.a)};
}

// source over stored, in linear light: c = c_s a + c_d (1 - a), and a = a_s + a_d (1 - a_s).
inline Rgba8 blend_over(Transfer transfer, const Rgba& source, const Rgba8& stored) {
  const float keep = 1.0f - source.a;
  return encode(transfer, Rgba{source.r * source.a + decode(transfer, stored.r) * keep,
                               source.g * source.a + decode(transfer, stored.g) * keep,
                               source.b * source.a + decode(transfer, stored.b) * keep,
                               source.a + decode_unorm8(stored.a) * keep});
}

inline void write_masked(const ColorMask& mask, const Rgba8& color, Rgba8& stored) {
  if (mask.r) stored.r = color.r;
  if (mask.g) stored.g = color.g;
  if (mask.b) stored.b = color.b;
  if (mask.a) stored.a = color.a;
}

}  // namespace glassbox
