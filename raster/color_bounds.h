// Bounds on the errors of a fragment's colours: the level of detail, a sample of a texture, and the
// stored bytes. The image's bytes, and the transfer function as a function of real numbers, have no
// error here. The inputs of the functions have error bounds of their own.
//
// The exact sample of level k is a weighted mean of the level's texels, without any rounding: the
// texels are exact means of the image's light, and the weights belong to the exact coordinates. The
// error of the computed sample is the sum of these errors, in units of 1/kFullTexel unless stated
// otherwise:
//
// - Texels: 1/2 for rounding the light of a byte (0 where bytes are linear). For each level after
//   level 0, 1/2 for rounding its texels, and 0.03 for the floats that their means are computed in:
//   12 u of kFullTexel (u is the unit roundoff, 2^-24) for two weights, their products and a sum of
//   nine terms, and u of kFullTexel for the sum with 1/2.
// - Mixing: 1.5 across, 1.5 down, 1.5 between levels (formulas/texture.h); 0 if the sample is a
//   single texel.
// - Place: with linear filters, a sample is a continuous function of x, y and the level. If x or y
//   changes by one texel, or the level by one, the sample changes by no more than the contrast D,
//   the largest difference of a channel between texels within reach. So the error is D (ex + ey +
//   el), where ex and ey are the errors of x and y in texels and el is the error of the level. If
//   the level is W texels wide, ex = W (du + 3 * 2^-23), where du bounds the error of the
//   coordinate. The rest is, in units of W: 2^-24 for wrapping the coordinate, 2^-23 for rounding
//   its product with W, which is up to 2 W, and 2^-23 for subtracting 1/2; together less than 3 *
//   2^-23.
// - Choice: of the nearest texel, of the nearest level, or between the filters for enlarging and
//   for shrinking. If the error bounds allow a different choice, the error is the whole of D.
// - Light: 2 u, in units of light, for rounding 1/kFullTexel and the product with it.
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
// longer side. The errors of log2_positive() are 5e-8 because its series ends early, 8 u (u is the
// unit roundoff, 2^-24) of at most 1/2 for rounding in the series, and u for the sum with the
// exponent. These errors are halved with the logarithm.
LevelBounds level_bounds(float level, const bounded::Bounded& squared_texels);

// The bound of the error of a sample in linear light: the largest over its colour channels and
// alpha.
double sample_bound(const MipChain& texture, const Sampler& sampler, Transfer transfer,
                    const std::array<bounded::Bounded, 2>& texcoord, const LevelBounds& level);

// Bounds how far a stored byte may be from 255 times the transfer function of the exact light. The
// function is monotone, so the exact value is between the encoded ends of the light's interval. If
// the light is exact, the bound is half a byte.
double stored_bound(Transfer transfer, std::uint8_t stored, const bounded::Bounded& light);

// Returns the light of a stored byte that may be off by `bound` bytes.
bounded::Bounded light_of_stored(Transfer transfer, std::uint8_t stored, double bound);

}  // namespace glassbox
