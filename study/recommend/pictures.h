// Whole pictures: their colours against many more samples.
#pragma once

#include <functional>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

// The view that is asked for, in a picture `factor` times as wide and high. Its depth range is the settings' format's.
using ViewOf = std::function<Result<View>(const RenderSettings& settings, int factor)>;

struct ReferencePicture {
  Image<Rgba8> image;
  int factor = 1;  // it was drawn that much wider and higher
  DepthFormat depth = DepthFormat::kFloat32Reversed;
};

// The nearest to the right picture that there is: drawn up to 4 x 4 times as large with 16 samples a pixel, and averaged in
// light. Its shading, and how its textures are filtered, are as asked for; so is its depth
// format where the view cannot be had with the most exact one, reversed floats.
Result<ReferencePicture> reference_picture(const Scene& scene, const ViewOf& view,
                                           const RenderSettings& settings);

// Every block of factor x factor pixels averaged in linear light, encoded again.
Image<Rgba8> shrunk(const Image<Rgba8>& large, int factor, Transfer transfer);

// The root mean square difference of red, green and blue, 1 for the whole range of a byte. Both have the same size.
double color_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference);

}  // namespace glassbox::study
