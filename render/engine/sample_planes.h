// The colours and depths of several samples per pixel, kept while a picture is drawn.
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

// The samples of a whole picture, or of one tile. The colours of a pixel's samples are stored next
// to each other, and so are their depths: 8 bytes for each sample.
class SamplePlanes {
public:
  // Clears all samples of the pixels of `window`: their depth becomes kEmptyDepth, their colour is
  // `color`, or the colour that their pixel has in `picture`.
  void clear(const PixelRect& window, int count, const Rgba8& color);
  void clear(const PixelRect& window, int count, const Image<Rgba8>& picture);

  bool empty() const { return depth_.empty(); }
  int count() const { return count_; }
  std::span<Rgba8> colors(int x, int y) { return std::span(color_).subspan(at(x, y), size()); }
  std::span<std::uint32_t> depths(int x, int y) {
    return std::span(depth_).subspan(at(x, y), size());
  }

  // Access to the same memory for the vectorised code.
  SampleRows rows() { return {window_, color_.data(), depth_.data(), count_}; }

  // Writes the mean of each pixel's samples (mean_color.h) to `picture`, in the channels of the
  // settings' mask.
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
  std::vector<std::uint32_t> depth_;  // depth codes, see depth_code()
};

}  // namespace glassbox
