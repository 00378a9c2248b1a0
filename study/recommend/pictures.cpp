#include "study/recommend/pictures.h"

#include <algorithm>
#include <cmath>

#include <glassbox/raster/transfer.h>
#include <glassbox/render/renderer.h>

namespace glassbox::study {

Image<Rgba8> downsample(const Image<Rgba8>& large, int factor, Transfer transfer) {
  Image<Rgba8> small(large.width / factor, large.height / factor, {});
  const double share = 1.0 / (factor * factor);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      double sum[3] = {};
      for (int j = 0; j < factor; ++j) {
        for (int i = 0; i < factor; ++i) {
          const Rgba8& p = large.at(x * factor + i, y * factor + j);
          sum[0] += double(decode(transfer, p.r));
          sum[1] += double(decode(transfer, p.g));
          sum[2] += double(decode(transfer, p.b));
        }
      }
      small.at(x, y) = {encode(transfer, float(sum[0] * share)),
                        encode(transfer, float(sum[1] * share)),
                        encode(transfer, float(sum[2] * share)), 255};
    }
  }
  return small;
}

namespace {

// Whether the scene has lines or points, which are one pixel wide in a picture of any size: they
// would become thinner when the picture is made smaller.
bool has_pixel_wide_things(const Scene& scene, const RenderSettings& settings) {
  return settings.wireframe || std::ranges::any_of(scene.meshes, [](const Mesh& mesh) {
           return !mesh.lines.empty() || !mesh.points.empty();
         });
}

int reference_factor(const Scene& scene, const View& view, const RenderSettings& settings) {
  constexpr int kMost = 4;
  if (has_pixel_wide_things(scene, settings)) return 1;
  const float side = std::max(view.viewport.width(), view.viewport.height());
  return std::clamp(kMaxImageSide / int(side), 1, kMost);
}

}  // namespace

Result<ReferencePicture> reference_picture(const Scene& scene, const ViewOf& view,
                                           const RenderSettings& asked) {
  RenderSettings settings = asked;
  settings.samples = 16;
  settings.depth = DepthFormat::kFloat32Reversed;
  Result<View> small = view(settings, 1);
  if (!small) {
    settings.depth = asked.depth;
    small = view(settings, 1);
  }
  if (!small) return tl::unexpected(small.error());
  const int factor = reference_factor(scene, *small, settings);
  return view(settings, factor).map([&](const View& large) {
    Renderer renderer(scene, settings.transfer);
    return ReferencePicture{
        downsample(renderer.render(large, settings).buffers.color, factor, settings.transfer),
        factor, settings.depth};
  });
}

double color_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgba8 &a = picture.at(x, y), &b = reference.at(x, y);
      const int red = a.r - b.r, green = a.g - b.g, blue = a.b - b.b;
      sum += red * red + green * green + blue * blue;  // a sum of integers: exact in any order
    }
  }
  return std::sqrt(sum / (3.0 * picture.width * picture.height)) / 255;
}

}  // namespace glassbox::study
