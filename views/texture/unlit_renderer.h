// A surface's own colours, as cameras of the geometry see them, with each pixel's polygon and distance.
#pragma once

#include <glassbox/mesh/scene.h>
#include <glassbox/render/renderer.h>

#include "views/rings/ring.h"

namespace glassbox::views {

class UnlitRenderer {
public:
  // The scene must outlive it.
  explicit UnlitRenderer(const Scene& scene);

  // The camera must be before the scene's box.
  Result<Framebuffer> draw(const PinholeCamera& camera, int width, int height,
                           Rgba8 background = {0, 0, 0, 255});

private:
  WorldBox box_;
  Renderer renderer_;
};

}  // namespace glassbox::views
