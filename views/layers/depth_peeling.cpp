#include "views/layers/depth_peeling.h"

#include <algorithm>
#include <cmath>

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

bool is_empty(const Image<float>& distance) {
  return std::ranges::none_of(distance.pixels, [](float z) { return std::isfinite(z); });
}

}  // namespace

std::vector<Layer> peel(const Scene& scene, const View& view, const RenderSettings& settings,
                        int layers) {
  std::vector<Layer> peeled;
  Image<std::uint32_t> shown;
  for (int i = 0; i < layers; ++i) {
    Peeler peeler(shown);
    Rendering pass = render_staged(scene, view, settings, i == 0 ? nullptr : &peeler);
    if (i > 0 && is_empty(pass.buffers.distance)) break;
    peeled.push_back({std::move(pass.buffers.color), std::move(pass.buffers.distance)});
    shown = std::move(pass.buffers.depth);
  }
  return peeled;
}

}  // namespace glassbox::views
