#include "study/experiments/warp/warp.h"

#include <cmath>
#include <limits>

#include <glassbox/pipeline/stereo/parallax.h>

namespace glassbox::study {

Warped warp(const std::vector<Layer>& layers, const View& centre, const StereoPair& pair,
            Rgba8 background) {
  const int width = layers.front().color.width, height = layers.front().color.height;
  Warped warped{Image<Rgba8>(width, height, background),
                Image<float>(width, height, std::numeric_limits<float>::infinity())};
  // The parallax at the distance z is p(z) = a - b/z (parallax.h). a is its value at infinity; b
  // follows from the window, where the parallax is 0.
  const double a = parallax_at(centre, pair, std::numeric_limits<double>::infinity()).px,
               b = a * pair.window;
  for (const Layer& layer : layers) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const float z = layer.distance.at(x, y);
        if (!std::isfinite(z)) continue;
        const int to = int(std::floor(x + 0.5 + (a - b / double(z))));
        if (to < 0 || to >= width || z >= warped.distance.at(to, y)) continue;
        warped.distance.at(to, y) = z;
        warped.color.at(to, y) = layer.color.at(x, y);
      }
    }
  }
  return warped;
}

void fill_holes(Warped& picture) {
  const int width = picture.color.width;
  const auto is_hole = [&](int x, int y) { return !std::isfinite(picture.distance.at(x, y)); };
  for (int y = 0; y < picture.color.height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!is_hole(x, y)) continue;
      int end = x;
      while (end < width && is_hole(end, y)) ++end;
      const float left = x > 0 ? picture.distance.at(x - 1, y) : -1,
                  right = end < width ? picture.distance.at(end, y) : -1;
      if (left < 0 && right < 0) break;  // an empty row
      const int from = left > right ? x - 1 : end;
      for (; x < end; ++x) {
        picture.color.at(x, y) = picture.color.at(from, y);
        picture.distance.at(x, y) = picture.distance.at(from, y);
      }
    }
  }
}

}  // namespace glassbox::study
