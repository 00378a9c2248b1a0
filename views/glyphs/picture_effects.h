// Changes pictures as photography does: blur, light of another colour, JPEG compression, and
// objects in front of the wall (S1-26 to S1-28).
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::views {

// Blurs linear light with a Gaussian of this standard deviation, px.
Image<Rgba8> blurred(const Image<Rgba8>& picture, double deviation);

// Multiplies the light of each channel by a gain; values above white become white.
Image<Rgba8> with_gains(const Image<Rgba8>& picture, const std::array<double, 3>& gains);

// The picture after JPEG compression (ITU-T T.81, JFIF) at a quality of 1 .. 100 as in the IJG's
// library: colours become Y, Cb and Cr, the latter two are averaged over 2 x 2 pixels, and the
// cosine transform's coefficients of blocks of 8 x 8 are rounded to multiples of the numbers in
// Annex K's tables, which the quality scales. The later steps of JPEG lose nothing and are left
// out.
Image<Rgba8> apply_jpeg(const Image<Rgba8>& picture, int quality);

// Dark bars at random places, each 1/16 of the picture's height wide, until they cover the fraction
// `share` of the pixels.
struct OccludedPicture {
  Image<Rgba8> picture;
  Image<std::uint8_t> covered;  // 255 where a bar is
};
OccludedPicture occluded(const Image<Rgba8>& picture, double share, std::uint64_t seed);

}  // namespace glassbox::views
