#include "views/layers/depth_peeling.h"

#include <algorithm>

#include <glassbox/render/staged/staged.h>

namespace glassbox::views {

namespace {

class Peeler : public Observer {
public:
  explicit Peeler(const Image<std::uint32_t>& shown) : shown_(shown) {}

  void compared(const FragmentSource&, const Fragment& fragment, std::uint32_t code, std::uint32_t,
                bool& in_front) override {
    in_front = in_front && code > shown_.at(fragment.x, fragment.y);
  }

private:
  const Image<std::uint32_t>& shown_;  // depth codes
};

bool is_empty(const Image<std::uint32_t>& depth) {
  return std::ranges::all_of(depth.pixels, [](std::uint32_t code) { return code == kEmptyDepth; });
}

}  // namespace

std::vector<Layer> peel(const Scene& scene, const View& view, const RenderSettings& settings,
                        int layers) {
  Rendering first = render_staged(scene, view, settings);
  std::vector<Layer> peeled;
  Framebuffer& buffers = first.buffers;
  peeled.push_back({std::move(buffers.color), std::move(buffers.distance), buffers.depth});
  for (Layer& layer : peel_behind(scene, view, settings, std::move(buffers.depth), layers - 1)) {
    peeled.push_back(std::move(layer));
  }
  return peeled;
}

std::vector<Layer> peel_behind(const Scene& scene, const View& view, const RenderSettings& settings,
                               Image<std::uint32_t> shown, int layers,
                               const std::function<void(Image<std::uint32_t>& codes)>& behind) {
  std::vector<Layer> peeled;
  for (int i = 0; i < layers; ++i) {
    behind(shown);
    Peeler peeler(shown);
    Rendering pass = render_staged(scene, view, settings, &peeler);
    if (is_empty(pass.buffers.depth)) break;
    peeled.push_back(
        {std::move(pass.buffers.color), std::move(pass.buffers.distance), pass.buffers.depth});
    shown = std::move(pass.buffers.depth);
  }
  return peeled;
}

}  // namespace glassbox::views
