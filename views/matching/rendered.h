// A pair from the rasterizer, whose every disparity is known.
#pragma once

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/settings.h>

#include "views/matching/calibration.h"
#include "views/matching/evaluate.h"

namespace glassbox::views {

struct RenderedPair {
  Image<Rgba8> left, right;
  StereoTruth truth;  // visible: by reprojection into the other picture and its distances
  Image<std::uint8_t> is_textured;  // has_texture() of the left picture
  Calibration calibration;
};

// Pixels with contrast of their own: of those pixels in a window of 9 x 7 whose disparity is within a pixel of the centre's, two in
// one row differ by at least 8 codes of grey. Elsewhere two pictures say nothing about the surface's disparity (C-111); an outline
// against what is behind does not count, because it is as well the edge of that.
Image<std::uint8_t> has_texture(const Image<Rgba8>& picture, const Image<float>& disparity);

// The truth is d = f B / z - f B / window, of each pixel's centre.
Result<RenderedPair> rendered_pair(const Scene& scene, const View& centre, const StereoPair& eyes,
                                   const RenderSettings& settings);

}  // namespace glassbox::views
