// The images on the surfaces of the built-in scenes, computed with integers.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox {

// A pseudo-random number computed from x, the same on every machine (the last step of the generator
// SplitMix64, Steele et al. 2014).
std::uint64_t scramble(std::uint64_t x);
// A number uniformly distributed in [0, 1), a multiple of 2^-53; a different sequence for each
// seed.
double random_unit(std::uint64_t seed, std::uint64_t index);

// `cells` x `cells` squares of `cell_px` pixels in two alternating colours; the top left square has
// the first colour.
Image<Rgba8> make_checks(int cells, int cell_px, Rgba8 first, Rgba8 second);

// An image whose colour varies by up to `amplitude` steps per channel, from pixel to pixel and from
// patch to patch. It repeats without seams. The side is a power of two, at least 16 px.
Image<Rgba8> make_noise(int side_px, Rgba8 color, int amplitude, std::uint64_t seed);

// An image of horizontal boards, each 16 px high and of a slightly different shade, with dark
// joints; the image is 128 px wide and high.
Image<Rgba8> make_boards(Rgba8 color, std::uint64_t seed);

}  // namespace glassbox
