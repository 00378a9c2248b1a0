// A stereo pair drawn by the rasterizer, with the true disparity of every pixel.
#pragma once

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/settings.h>

#include "views/matching/calibration.h"
#include "views/matching/disparity_errors.h"

namespace glassbox::views {

struct RenderedPair {
  Image<Rgba8> left, right;
  // is_visible is found by projecting each point into the right picture and comparing its distance
  // with the one that is drawn there.
  StereoTruth truth;
  Image<std::uint8_t> is_textured;  // has_texture() of the left picture
  Calibration calibration;
};

// Whether each pixel's own surface has contrast: among the pixels in a window of 9 x 7 whose
// disparity is within a pixel of the centre's, two in the same row differ by at least 8 levels of
// grey. Without contrast, two pictures do not determine the surface's disparity (C-111). An outline
// against the background is no such contrast, because its two sides are on different surfaces.
Image<std::uint8_t> has_texture(const Image<Rgba8>& picture, const Image<float>& disparity);

// Draws the pair. The true disparity at a pixel's centre is d = f B / z - f B / window, with the
// focal length f in px, the distance B between the eyes, and the distances of the point (z) and of
// the window along the direction of view.
Result<RenderedPair> rendered_pair(const Scene& scene, const View& centre, const StereoPair& eyes,
                                   const RenderSettings& settings);

}  // namespace glassbox::views
