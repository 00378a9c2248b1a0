#include "views/matching/color_planes.h"

namespace glassbox::views {

ColorPlanes color_planes(const Image<Rgba8>& image) {
  ColorPlanes planes{image.width, image.height, {}, {}, {}, {}};
  for (auto* plane : {&planes.r, &planes.g, &planes.b, &planes.grey}) {
    plane->resize(image.pixels.size());
  }
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgba8& pixel = image.pixels[i];
    planes.r[i] = pixel.r;
    planes.g[i] = pixel.g;
    planes.b[i] = pixel.b;
    planes.grey[i] = std::uint8_t((77 * pixel.r + 150 * pixel.g + 29 * pixel.b + 128) >> 8);
  }
  return planes;
}

}  // namespace glassbox::views
