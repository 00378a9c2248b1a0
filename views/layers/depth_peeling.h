// A layered depth image: at each pixel the nearest surface, the one behind it, and so on (Shade et al. 1998; S1-01).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::views {

struct Layer {
  Image<Rgba8> color;
  Image<float> distance;            // along the gaze; infinite where there is nothing
  Image<std::uint32_t> depth = {};  // codes
};

// By depth peeling: each pass of the staged reference hides all fragments that are not behind what the pass before has shown
// (Everitt 2001). `layers` passes; fewer where a pass shows nothing.
std::vector<Layer> peel(const Scene& scene, const View& view, const RenderSettings& settings,
                        int layers);

// The layers behind a picture whose depth codes are `shown`. What counts as behind is for `behind` to say, which gets the codes of
// what was shown, and makes them those that have to be exceeded.
std::vector<Layer> peel_behind(
    const Scene& scene, const View& view, const RenderSettings& settings,
    Image<std::uint32_t> shown, int layers,
    const std::function<void(Image<std::uint32_t>& codes)>& behind = [](auto&) {});

}  // namespace glassbox::views
