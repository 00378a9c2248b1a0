#include "study/bench/mesa/limits.h"

#include <algorithm>

#include <fmt/format.h>

namespace glassbox::study {

namespace {

// Limits of llvmpipe in Mesa 22.3: samples per pixel, and texels along the side of a texture.
constexpr int kPeerSamples = 4;
constexpr int kPeerTextureSide = 16384;

bool has_lines_or_points(const Scene& scene) {
  return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    return !mesh.lines.empty() || !mesh.points.empty();
  });
}

// Whether OpenGL magnifies where Glassbox already minifies: with these filters, OpenGL 3.3 (section
// 3.8.11) still magnifies up to half a mipmap level beyond the point where a pixel's footprint is
// one texel.
bool magnifies_elsewhere(const Sampler& sampler) {
  return sampler.magnify == Filter::kLinear && sampler.minify == Filter::kNearest &&
         sampler.mip != MipFilter::kNone;
}

}  // namespace

std::optional<std::string> peer_cannot_draw(const BenchScene& bench) {
  const Scene& scene = bench.scene;
  const int samples = bench.settings.samples;
  if (samples != 1 && samples != kPeerSamples) {
    return fmt::format("the peer draws with 1 or {} samples per pixel, not with {}", kPeerSamples,
                       samples);
  }
  if (has_lines_or_points(scene)) {
    return "the peer's lines and points cover other pixels than Glassbox's";
  }
  if (std::ranges::any_of(scene.textures, [](const Texture& texture) {
        return magnifies_elsewhere(texture.sampler);
      })) {
    return "a texture has different filters for magnification and minification, and the peer "
           "switches between them at another texel size";
  }
  if (std::ranges::any_of(scene.images, [](const Image<Rgba8>& image) {
        return std::max(image.width, image.height) > kPeerTextureSide;
      })) {
    return fmt::format("the peer's textures have at most {} texels on a side", kPeerTextureSide);
  }
  return std::nullopt;
}

}  // namespace glassbox::study
