// Finds which texel of a row belongs to a coordinate.
#pragma once

#include <functional>

#include <glassbox/raster/texture.h>

namespace glassbox::study {

using TexelAt = std::function<int(Wrap wrap, float t, int size)>;

// The number of the texel that the pipeline's nearest sampling takes from a row of `size` texels.
inline int pipeline_texel(Wrap wrap, float t, int size) {
  Image<Rgba8> row(size, 1);
  for (int i = 0; i < size; ++i)
    row.at(i, 0) = {std::uint8_t(i & 255), std::uint8_t(i >> 8), 0, 255};
  const Sampler sampler{wrap, wrap, Filter::kNearest, Filter::kNearest, MipFilter::kNone};
  const MipChain texture = make_mip_chain(row, Transfer::kNone, true);
  const Rgba seen = sample_mip_chain(texture, sampler, {t, 0}, 0);
  return int(seen.r * 255 + 0.5f) + 256 * int(seen.g * 255 + 0.5f);
}

}  // namespace glassbox::study
