// Colours and depths of several samples to a pixel, while they are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/tables.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// Of a whole picture, or of one tile. A pixel's samples are neighbours; 8 bytes each.
class SamplePlanes {
public:
  // All samples of the pixels of `window`: empty depth, and this colour; or each the colour that its pixel has in `picture`.
  void clear(const PixelRect& window, int count, const Rgba8& color);
  void clear(const PixelRect& window, int count, const Image<Rgba8>& picture);

  bool empty() const { return depth_.empty(); }
  int count() const { return count_; }
  std::span<Rgba8> colors(int x, int y) { return std::span(color_).subspan(at(x, y), size()); }
  std::span<std::uint32_t> depths(int x, int y) {
    return std::span(depth_).subspan(at(x, y), size());
  }

  // The same memory, for the lanes.
  SampleRows rows() { return {window_, color_.data(), depth_.data(), count_}; }

  // The mean of each pixel's samples (mean_color.h), into the channels of the settings' mask.
  void resolve(const RenderSettings& settings, Image<Rgba8>& picture) const;

private:
  std::size_t size() const { return std::size_t(count_); }
  std::size_t at(int x, int y) const {
    return (std::size_t(y - window_.y0) * std::size_t(window_.x1 - window_.x0) +
            std::size_t(x - window_.x0)) *
           size();
  }

  PixelRect window_;
  int count_ = 0;
  std::vector<Rgba8> color_;
  std::vector<std::uint32_t> depth_;  // depth_code()
};

}  // namespace glassbox
