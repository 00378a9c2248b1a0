// The right eye's picture from what the left eye sees, pixel by pixel along its rows (S1-09, B.9).
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

// Every pixel of every layer goes where its parallax puts it, one pixel wide; the nearest stays.
Warped warp(const std::vector<Layer>& layers, const View& centre, const StereoPair& pair,
            Rgba8 background);

// Holes get the colour and the distance of the farther of the pixels on either side: what is behind goes on there.
void fill_holes(Warped& picture);

}  // namespace glassbox::study
