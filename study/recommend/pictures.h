// Compares whole pictures with a reference that has many more samples.
#pragma once

#include <functional>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

// Makes the requested view for a picture `factor` times as wide and high. Its depth range is that
// of the depth format in `settings`.
using ViewOf = std::function<Result<View>(const RenderSettings& settings, int factor)>;

struct ReferencePicture {
  Image<Rgba8> image;
  int factor = 1;  // how many times wider and higher it was drawn
  DepthFormat depth = DepthFormat::kFloat32Reversed;
};

// The best approximation of the correct picture: drawn up to 4 x 4 times as large with 16 samples a
// pixel, and averaged in linear light. Shading and texture filters are those of `settings`; so is
// the depth format if the view is impossible with the most exact one, reversed floats.
Result<ReferencePicture> reference_picture(const Scene& scene, const ViewOf& view,
                                           const RenderSettings& settings);

// Averages each block of factor x factor pixels in linear light and encodes the mean again.
Image<Rgba8> downsample(const Image<Rgba8>& large, int factor, Transfer transfer);

// The root mean square difference of red, green and blue; 1 for the whole range of a byte. Both
// pictures have the same size.
double color_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference);

}  // namespace glassbox::study
