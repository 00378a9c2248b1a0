// What a photograph does to a picture: blur, another white, JPEG's rounding, things that stand before the wall (SPEC S1-26 to S1-28).
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::views {

// By a Gaussian of this deviation, px, in light.
Image<Rgba8> blurred(const Image<Rgba8>& picture, double deviation);

// Light of each channel times a gain; what is more than white is white.
Image<Rgba8> with_gains(const Image<Rgba8>& picture, const std::array<double, 3>& gains);

// What JPEG (ITU-T T.81, JFIF) keeps at a quality of 1 .. 100 as the IJG's library counts it: colours as Y, Cb and Cr, both of these of
// 2 x 2 pixels, and of blocks of 8 x 8 the cosine transform's coefficients, rounded to multiples of Annex K's tables. What follows in a
// file loses nothing, and is left out.
Image<Rgba8> through_jpeg(const Image<Rgba8>& picture, int quality);

// Dark bars at random, each a sixteenth of the picture's height wide, until they cover this share of the pixels.
struct OccludedPicture {
  Image<Rgba8> picture;
  Image<std::uint8_t> covered;  // 255 where a bar is
};
OccludedPicture occluded(const Image<Rgba8>& picture, double share, std::uint64_t seed);

}  // namespace glassbox::views
