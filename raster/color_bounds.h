// Bounds on the errors of a fragment's colours: the level of detail, a sample of a texture, and the
// stored bytes. The image's bytes and the transfer function on real numbers count as exact. The
// inputs bring their own bounds.
//
// The exact sample of level k is a mix of real-valued means of the image's light, by real weights
// at the real coordinates. The error of the computed sample, in units of 1/kFullTexel unless stated
// otherwise:
//
// - Texels: 1/2 for the byte's light (0 where bytes are linear). For each level 1/2 for its
//   rounding and 0.03 for the floats that its mean is computed in: 12 u of kFullTexel for two
//   weights, their products and a sum of nine, and u of it for the sum with 1/2.
// - Mixing: 1.5 across, 1.5 down, 1.5 between levels (formulas/texture.h); 0 where one texel alone
//   decides.
// - Place: where filters are linear, a sample is a continuous function of x, y and the level. For
//   each texel along x or y, and for each level, it changes by no more than the contrast D of the
//   texels within reach. So the error is D (ex + ey + el), with ex = W (du + 3 * 2^-23) texels: du
//   is the bound of the coordinate, 2^-24 for wrapping it, 2^-23 each of up to 2 W for the product
//   with W and for subtracting the half; both together are less than two of them.
// - Choice: the nearest texel, the nearest level, or another filter beyond level 0. Where numbers
//   within their bounds could choose differently, the error is the whole of D.
// - Light: 2 u for 1/kFullTexel and the product.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/base/bounded.h>
#include <glassbox/raster/texture.h>

namespace glassbox {

// A range that holds both the exact level of detail and the computed one.
struct LevelBounds {
  double low = 0, high = 0;
};

// `level` is the computed level of detail: half of log2_positive() of the square of the footprint's
// longer side. log2_positive() adds 5e-8 for the end of its series, 8 u of at most 1/2 for the rest
// of it, and u for the sum with the exponent; these errors are halved with the logarithm.
LevelBounds level_bounds(float level, const bounded::Bounded& squared_texels);

// The bound of a sample in linear light: the largest over its colour channels and alpha.
double sample_bound(const MipChain& texture, const Sampler& sampler, Transfer transfer,
                    const std::array<bounded::Bounded, 2>& texcoord, const LevelBounds& level);

// Bounds how far a stored byte may be from 255 times the transfer function of the exact light. The
// function is monotone, so the exact value is between the encoded ends of the light's interval.
// Half a byte where the light is exact.
double stored_bound(Transfer transfer, std::uint8_t stored, const bounded::Bounded& light);

// Returns the light of a stored byte that may be off by `bound` bytes.
bounded::Bounded light_of_stored(Transfer transfer, std::uint8_t stored, double bound);

}  // namespace glassbox
