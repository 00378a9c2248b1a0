#include "study/scenes/edges.h"

#include <algorithm>

#include <glassbox/raster/stages.h>

namespace glassbox::study {

namespace {

constexpr int kX = 0, kY = 1, kW = 3;  // indices of rows in clip space

bool differs_around(const Image<std::uint32_t>& id, int x, int y) {
  const std::uint32_t here = id.at(x, y);
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, id.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, id.width - 1); ++u) {
      if (id.at(u, v) != here) return true;
    }
  }
  return false;
}

}  // namespace

void mark_edges(const Image<std::uint32_t>& id, Image<std::uint8_t>& edge) {
  for (int y = 0; y < id.height; ++y) {
    for (int x = 0; x < id.width; ++x) {
      if (differs_around(id, x, y)) edge.at(x, y) = 1;
    }
  }
}

void mark_differences(const Image<std::uint32_t>& a, const Image<std::uint32_t>& b,
                      Image<std::uint8_t>& edge) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i] != b.pixels[i]) edge.pixels[i] = 1;
  }
}

// Moves the picture by -offset, so that what was at the sample is now at the pixel centre. The
// signs of x and y differ because y points down on the screen.
View view_at_sample(View view, const SampleOffset& offset) {
  const double x = -2.0 * offset.x / kSubpixels / view.viewport.width();
  const double y = 2.0 * offset.y / kSubpixels / view.viewport.height();
  Transform<Clip, Eye>& clip_from_eye = view.clip_from_eye;
  for (int column = 0; column < 4; ++column) {
    const double w = clip_from_eye.at(kW, column);
    clip_from_eye.at(kX, column) += x * w;
    clip_from_eye.at(kY, column) += y * w;
  }
  return view;
}

}  // namespace glassbox::study
