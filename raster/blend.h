// The last stage: a fragment's colour is encoded, blended and written to the picture.
#pragma once

#include <glassbox/base/numbers.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/raster/color_mask.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

#include <glassbox/raster/formulas/blend.h>

// Encodes a linear colour as bytes. Channels that are not in `wanted` become 0.
inline Rgba8 encode(Transfer transfer, const Rgba& linear, const ColorMask& wanted = {}) {
  Rgba8 stored{0, 0, 0, 0};
  if (wanted.r) stored.r = encode(transfer, linear.r);
  if (wanted.g) stored.g = encode(transfer, linear.g);
  if (wanted.b) stored.b = encode(transfer, linear.b);
  if (wanted.a) stored.a = encode_unorm8(linear.a);
  return stored;
}

// Blends `source` over the stored colour, in linear light.
inline Rgba8 blend_over(Transfer transfer, const Rgba& source, const Rgba8& stored,
                        const ColorMask& wanted = {}) {
  return encode(transfer,
                Rgba{blended_channel(source.r, source.a, decode(transfer, stored.r)),
                     blended_channel(source.g, source.a, decode(transfer, stored.g)),
                     blended_channel(source.b, source.a, decode(transfer, stored.b)),
                     blended_channel(1.0f, source.a, decode_unorm8(stored.a))},
                wanted);
}

inline void write_masked(const ColorMask& mask, const Rgba8& color, Rgba8& stored) {
  if (mask.r) stored.r = color.r;
  if (mask.g) stored.g = color.g;
  if (mask.b) stored.b = color.b;
  if (mask.a) stored.a = color.a;
}

}  // namespace glassbox
