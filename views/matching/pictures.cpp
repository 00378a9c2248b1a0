#include "views/matching/pictures.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <tbb/parallel_for.h>

namespace glassbox::views {

Planes planes_of(const Image<Rgba8>& image) {
  Planes planes{image.width, image.height, {}, {}, {}, {}};
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

LineVector<std::uint32_t> census_words(const Planes& picture) {
  constexpr int kAcross = 3, kDown = 2;
  const int width = picture.width, height = picture.height;
  LineVector<std::uint32_t> words(picture.grey.size());
  tbb::parallel_for(0, height, [&](int y) {
    std::uint32_t* out = words.data() + std::size_t(y) * std::size_t(width);
    const std::uint8_t* centre = picture.grey.data() + std::size_t(y) * std::size_t(width);
    std::vector<std::uint8_t> row(std::size_t(width + 2 * kAcross));
    for (int dy = -kDown; dy <= kDown; ++dy) {
      const int from = std::clamp(y + dy, 0, height - 1);
      const std::uint8_t* grey = picture.grey.data() + std::size_t(from) * std::size_t(width);
      std::fill_n(row.begin(), kAcross, grey[0]);
      std::copy_n(grey, width, row.begin() + kAcross);
      std::fill_n(row.begin() + kAcross + width, kAcross, grey[width - 1]);
      for (int dx = -kAcross; dx <= kAcross; ++dx) {
        if (dy == 0 && (dx == 0 || std::abs(dx) == kAcross)) continue;
        const std::uint8_t* neighbour = row.data() + kAcross + dx;
        for (int x = 0; x < width; ++x) {
          out[x] = out[x] << 1 | std::uint32_t(neighbour[x] < centre[x]);
        }
      }
    }
  });
  return words;
}

}  // namespace glassbox::views
