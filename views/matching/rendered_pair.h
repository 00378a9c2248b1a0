// A pair drawn by the rasterizer, with the true disparity of every pixel.
#pragma once

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/settings.h>

#include "views/matching/calibration.h"
#include "views/matching/disparity_errors.h"

namespace glassbox::views {

struct RenderedPair {
  Image<Rgba8> left, right;
  // Visible: found by reprojection into the other picture, and from its distances.
  StereoTruth truth;
  Image<std::uint8_t> is_textured;  // has_texture() of the left picture
  Calibration calibration;
};

// Pixels whose own surface has contrast: take the pixels in a window of 9 x 7 whose disparity is
// within a pixel of the centre's; two of them in one row differ by at least 8 levels of grey.
// Elsewhere two pictures do not determine the surface's disparity (C-111). An outline against the
// background does not count, because it is the edge of both.
Image<std::uint8_t> has_texture(const Image<Rgba8>& picture, const Image<float>& disparity);

// The truth is d = f B / z - f B / window at each pixel's centre.
Result<RenderedPair> rendered_pair(const Scene& scene, const View& centre, const StereoPair& eyes,
                                   const RenderSettings& settings);

}  // namespace glassbox::views
