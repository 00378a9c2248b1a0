#include "views/layers/depth_peeling.h"

#include <algorithm>

#include <glassbox/render/renderer.h>

namespace glassbox::views {

bool is_empty(const Layer& layer) {
  return std::ranges::all_of(layer.depth.pixels,
                             [](std::uint32_t code) { return code == kEmptyDepth; });
}

const Material* transparent_material(const Scene& scene) {
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[scene.meshes[instance.mesh].material];
    if (material.alpha_mode == AlphaMode::kBlend) return &material;
  }
  return nullptr;
}

std::vector<Layer> peel(const Scene& scene, const View& view, const RenderSettings& settings,
                        int layers) {
  Renderer renderer(scene, settings.transfer);
  RenderSettings with_depth = settings;
  with_depth.want_depth = true;
  std::vector<Layer> peeled;
  for (int i = 0; i < layers; ++i) {
    Rendering pass;
    renderer.render(view, with_depth, pass, peeled.empty() ? nullptr : &peeled.back().depth);
    Framebuffer& buffers = pass.buffers;
    Layer layer{std::move(buffers.color), std::move(buffers.distance), std::move(buffers.depth),
                std::move(buffers.id)};
    if (i > 0 && is_empty(layer)) break;
    peeled.push_back(std::move(layer));
  }
  return peeled;
}

}  // namespace glassbox::views
