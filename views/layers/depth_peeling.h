// Depth peeling: makes a layered depth image, which has for each pixel the nearest surface, the one
// behind it, and so on (Shade et al. 1998; S1-01).
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
  Image<float> distance;  // along the direction of view; infinite where there is no surface
  Image<std::uint32_t> depth = {};  // as codes of a DepthFormat
  Image<std::uint32_t> id = {};     // as in Framebuffer::id, if the settings ask for it
};

bool is_empty(const Layer& layer);  // whether the layer shows no surface

// Returns the material of a transparent surface of the scene, or null if there is none. Such a
// surface hides nothing, so depth peeling cannot give it a layer of its own.
const Material* transparent_material(const Scene& scene);

// Peels a scene without transparent surfaces: each pass draws the nearest surfaces behind those of
// the pass before (Everitt 2001). There are `layers` passes, or fewer if a pass shows nothing.
std::vector<Layer> peel(const Scene& scene, const View& view, const RenderSettings& settings,
                        int layers);

}  // namespace glassbox::views
