// The last stage: what is written where.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/raster/color_mask.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

// Channels that are not wanted become 0.
inline Rgba8 encode(Transfer transfer, const Rgba& linear, const ColorMask& wanted = {}) {
  Rgba8 stored{0, 0, 0, 0};
  if (wanted.r) stored.r = encode(transfer, linear.r);
  if (wanted.g) stored.g = encode(transfer, linear.g);
  if (wanted.b) stored.b = encode(transfer, linear.b);
  if (wanted.a) stored.a = encode_unorm8(linear.a);
  return stored;
}

// source over stored, in linear light: c = c_s a + c_d (1 - a), and a = a_s + a_d (1 - a_s).
inline Rgba8 blend_over(Transfer transfer, const Rgba& source, const Rgba8& stored,
                        const ColorMask& wanted = {}) {
  const float keep = 1.0f - source.a;
  return encode(transfer,
                Rgba{source.r * source.a + decode(transfer, stored.r) * keep,
                     source.g * source.a + decode(transfer, stored.g) * keep,
                     source.b * source.a + decode(transfer, stored.b) * keep,
                     source.a + decode_unorm8(stored.a) * keep},
                wanted);
}

inline void write_masked(const ColorMask& mask, const Rgba8& color, Rgba8& stored) {
  if (mask.r) stored.r = color.r;
  if (mask.g) stored.g = color.g;
  if (mask.b) stored.b = color.b;
  if (mask.a) stored.a = color.a;
}

}  // namespace glassbox
