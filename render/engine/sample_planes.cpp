#include <glassbox/render/engine/sample_planes.h>

#include <algorithm>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/mean_color.h>

namespace glassbox {

namespace {

// Returns the transfer function for averaging samples. Pictures of normals and texture coordinates
// show numbers, not light, so they are averaged without decoding.
Transfer transfer_of_mean(const RenderSettings& settings) {
  const bool is_light = settings.show != Show::kNormal && settings.show != Show::kUv;
  return is_light ? settings.transfer : Transfer::kNone;
}

bool all_equal(std::span<const Rgba8> colors) {
  return std::ranges::all_of(colors, [&](const Rgba8& c) { return c == colors.front(); });
}

}  // namespace

void SamplePlanes::clear(const PixelRect& window, int count, const Rgba8& color) {
  window_ = window;
  count_ = count;
  const std::size_t pixels =
      std::size_t(window.x1 - window.x0) * std::size_t(window.y1 - window.y0);
  color_.assign(pixels * size(), color);
  depth_.assign(pixels * size(), kEmptyDepth);
}

void SamplePlanes::clear(const PixelRect& window, int count, const Image<Rgba8>& picture) {
  clear(window, count, Rgba8{});
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      std::ranges::fill(colors(x, y), picture.at(x, y));
    }
  }
}

void SamplePlanes::resolve(const RenderSettings& settings, Image<Rgba8>& picture) const {
  const Transfer transfer = transfer_of_mean(settings);
  for (int y = window_.y0; y < window_.y1; ++y) {
    for (int x = window_.x0; x < window_.x1; ++x) {
      const auto samples = std::span(color_).subspan(at(x, y), size());
      const Rgba8 mean = all_equal(samples) ? samples.front() : mean_color(transfer, samples);
      write_masked(settings.mask, mean, picture.at(x, y));
    }
  }
}

}  // namespace glassbox
