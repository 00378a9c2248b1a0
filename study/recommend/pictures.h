// Compares whole pictures with a reference that has many more samples.
#pragma once

#include <functional>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

// Makes the view for a picture that is `factor` times as wide and high as the requested one. Its
// depth range is that of the depth format in `settings`.
using ViewOf = std::function<Result<View>(const RenderSettings& settings, int factor)>;

struct ReferencePicture {
  Image<Rgba8> image;
  int factor = 1;  // how many times wider and higher it was drawn
  DepthFormat depth = DepthFormat::kFloat32Reversed;
};

// Draws the best approximation of the correct picture: up to 4 x 4 times as large with 16 samples
// per pixel, and averaged in linear light. It has the shading and texture filters of `settings`.
// Depths are reversed floats, the most exact format; if they do not allow the view, the depth
// format of `settings` is used.
Result<ReferencePicture> reference_picture(const Scene& scene, const ViewOf& view,
                                           const RenderSettings& settings);

// Averages each block of factor x factor pixels in linear light and encodes the mean again.
Image<Rgba8> downsample(const Image<Rgba8>& large, int factor, Transfer transfer);

// The root mean square difference of red, green and blue; 1 is the whole range of a byte. Both
// pictures have the same size.
double color_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference);

}  // namespace glassbox::study
