// A surface's own colours, as cameras of the geometry see them, with each pixel's polygon and distance.
#pragma once

#include <cstdint>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/renderer.h>

#include "views/rings/ring.h"

namespace glassbox::views {

class UnlitRenderer {
public:
  // The scene must outlive it.
  explicit UnlitRenderer(const Scene& scene);

  // What it takes for so many triangles and a picture of so many pixels: for a triangle its corners' numbers, as they are cut, prepared and
  // arranged by the engine; for a pixel colour, depth, distance and number.
  static double bytes_for(double triangles, double pixels) {
    constexpr double kTriangle = 6 * 3 * sizeof(std::uint32_t), kPixel = 4 * sizeof(std::uint32_t);
    return triangles * kTriangle + pixels * kPixel;
  }

  // The camera must be before the scene's box.
  Result<Framebuffer> draw(const PinholeCamera& camera, int width, int height,
                           Rgba8 background = {0, 0, 0, 255});

private:
  WorldBox box_;
  Renderer renderer_;
};

}  // namespace glassbox::views
