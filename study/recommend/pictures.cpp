#include "study/recommend/pictures.h"

#include <cmath>
#include <memory>

#include <glassbox/raster/transfer.h>
#include <glassbox/render/renderer.h>

#include "study/experiment/runner.h"
#include "study/experiment/timing.h"

namespace glassbox::study {

Image<Rgba8> shrunk(const Image<Rgba8>& large, int factor, Transfer transfer) {
  Image<Rgba8> small(large.width / factor, large.height / factor, {});
  const double share = 1.0 / (factor * factor);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      double sum[3] = {};
      for (int j = 0; j < factor; ++j) {
        for (int i = 0; i < factor; ++i) {
          const Rgba8& p = large.at(x * factor + i, y * factor + j);
          sum[0] += double(decode(transfer, p.r));
          sum[1] += double(decode(transfer, p.g));
          sum[2] += double(decode(transfer, p.b));
        }
      }
      small.at(x, y) = {encode(transfer, float(sum[0] * share)),
                        encode(transfer, float(sum[1] * share)),
                        encode(transfer, float(sum[2] * share)), 255};
    }
  }
  return small;
}

double color_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgba8 &a = picture.at(x, y), &b = reference.at(x, y);
      const int red = a.r - b.r, green = a.g - b.g, blue = a.b - b.b;
      sum += red * red + green * green + blue * blue;  // integers: exact in any order
    }
  }
  return std::sqrt(sum / (3.0 * picture.width * picture.height)) / 255;
}

std::vector<Quartiles> frame_times(const Scene& scene, std::span<const Shot> shots) {
  std::vector<std::unique_ptr<Renderer>> renderers;
  std::vector<TimedWork> works;
  for (const Shot& shot : shots) {
    TileOptions options;
    options.threads = 1;
    renderers.push_back(
        std::make_unique<Renderer>(scene, shot.settings.transfer, EngineKind::kTile, options));
    works.push_back({[renderer = renderers.back().get(), &shot] {
      renderer->render(shot.view, shot.settings);
    }});
  }
  std::vector<Quartiles> times;
  for (const Timed& each : time_in_turn(works, kLeastRepetitions)) times.push_back(each.ns);
  return times;
}

}  // namespace glassbox::study
