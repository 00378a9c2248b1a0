// Warps the left eye's layers to the right eye's picture, pixel by pixel along the rows (S1-09,
// B.9).
#pragma once

#include <vector>

#include <glassbox/pipeline/stereo/stereo_pair.h>

#include "views/layers/depth_peeling.h"

namespace glassbox::study {

using views::Layer;
using views::peel;

struct Warped {
  Image<Rgba8> color;
  Image<float> distance;  // infinite: a hole
};

// Moves every pixel of every layer by its parallax; each of them fills one pixel of the right
// picture, and the nearest stays.
Warped warp(const std::vector<Layer>& layers, const View& centre, const StereoPair& pair,
            Rgba8 background);

// Fills each hole with the colour and distance of the farther one of the pixels on both sides,
// because the background continues there.
void fill_holes(Warped& picture);

}  // namespace glassbox::study
