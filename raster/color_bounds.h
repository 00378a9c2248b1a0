// How far the colours of a fragment may be off: the level of detail, a sample of a texture, and the bytes that are stored. What
// counts as exact is the image's bytes and the transfer function as real numbers; what comes in brings its own bounds.
//
// A sample of level k stands for real means of the image's light, mixed by real weights at the real coordinates. Its error, in
// units of 1/kFullTexel unless said otherwise:
//
//   the texels    1/2 for the byte's light (0 where bytes are linear), and for each level 1/2 for its rounding and 0.03 for the
//                 floats that its mean was taken in: 12 u of kFullTexel for two weights, their products and a sum of nine, and u
//                 of it for the sum with 1/2
//   the mixing    1.5 across, 1.5 down, 1.5 between levels (formulas/texture.h); 0 for what one texel decides
//   the place     a sample is a continuous function of x, y and the level where filters are linear, and changes by no more than
//                 the contrast D of the texels that are within reach for each texel along x or y, and for each level. So D (ex +
//                 ey + el), with ex = W (du + 3 * 2^-23) texels: du of the coordinate, 2^-24 for wrapping it, 2^-23 each of up to
//                 2 W for the product with W and for the half that is subtracted, less than two of them together
//   a choice      the nearest texel, the nearest level, another filter beyond level 0: where the numbers within their bounds
//                 choose differently, D as a whole
//   the light     2 u for 1/kFullTexel and the product
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/base/bounded.h>
#include <glassbox/raster/texture.h>

namespace glassbox {

// Where the exact level of detail lies, and the run's.
struct LevelBounds {
  double low = 0, high = 0;
};

// `level`: what log2_positive made of a square of the footprint's longer side. It adds 5e-8 for the end of its series, 8 u of
// at most 1/2 for the rest of it, and u for the sum with the exponent; halved with the logarithm.
LevelBounds level_bounds(float level, const bounded::Bounded& squared_texels);

// Of each channel of a sample, in light; of colours and alpha, whichever is larger.
double sample_bound(const MipChain& texture, const Sampler& sampler, Transfer transfer,
                    const std::array<bounded::Bounded, 2>& texcoord, const LevelBounds& level);

// How far a stored byte may be from 255 times the transfer function of the exact light: that is monotone, so it lies between what
// both ends of the light's bound are encoded as. Half a byte where the light is exact.
double stored_bound(Transfer transfer, std::uint8_t stored, const bounded::Bounded& light);

// The light of a stored byte that may be off by `bound` bytes.
bounded::Bounded light_of_stored(Transfer transfer, std::uint8_t stored, double bound);

}  // namespace glassbox
