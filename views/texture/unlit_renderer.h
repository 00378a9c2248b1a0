// Draws a surface's own colours without light, with the polygon and the distance of each pixel.
#pragma once

#include <cstdint>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/renderer.h>

#include "views/rings/ring.h"

namespace glassbox::views {

class UnlitRenderer {
public:
  // The scene must outlive the renderer.
  explicit UnlitRenderer(const Scene& scene);

  // Bytes needed for this many triangles and a picture of this many pixels. For a triangle: the
  // numbers of its corners, while the engine clips, prepares and sorts it. For a pixel: colour,
  // depth, distance and polygon number.
  static double bytes_for(double triangles, double pixels) {
    constexpr double kTriangle = 6 * 3 * sizeof(std::uint32_t), kPixel = 4 * sizeof(std::uint32_t);
    return triangles * kTriangle + pixels * kPixel;
  }

  // The camera must be in front of the scene's box.
  Result<Framebuffer> draw(const PinholeCamera& camera, int width, int height,
                           Rgba8 background = {0, 0, 0, 255});

private:
  WorldBox box_;
  Renderer renderer_;
};

}  // namespace glassbox::views
