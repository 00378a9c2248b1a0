// A layered depth image: at each pixel the nearest surface, the one behind it, and so on (Shade et al. 1998; S1-01).
#pragma once

#include <cstdint>
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
  Image<std::uint32_t> id = {};     // as Framebuffer::id, if the settings want it
};

bool is_empty(const Layer& layer);  // it shows nothing

// What some drawn surface wears that is seen through, if anything: it hides nothing, and has no layer of its own.
const Material* seen_through(const Scene& scene);

// By depth peeling: each pass draws what is behind what the pass before has shown (Everitt 2001). `layers` passes; fewer where a pass shows
// nothing. Of a scene in which nothing is seen through.
std::vector<Layer> peel(const Scene& scene, const View& view, const RenderSettings& settings,
                        int layers);

}  // namespace glassbox::views
