// A layered depth image: each pixel of one camera has several surfaces, one behind the other
// (Shade, Gortler, He and Szeliski 1998; S1-01).
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/layers/layer_camera.h"

namespace glassbox::views {

// A surface's unit normal in the world, times 127 and rounded to whole numbers; all 0: unknown.
struct SampleNormal {
  std::int8_t x = 0, y = 0, z = 0;

  bool is_known() const { return x != 0 || y != 0 || z != 0; }
  friend auto operator<=>(const SampleNormal&, const SampleNormal&) = default;
};

// Packed in the order of drawing (S1-06): rows from the bottom to the top, pixels from left to
// right, samples of a pixel from back to front.
struct LayeredImage {
  LayerCamera camera;
  // width * height + 1 ascending offsets: the samples of a pixel begin at first[pixel_index(x, y)]
  // and end where those of the next pixel begin.
  std::vector<std::uint32_t> first;
  // As in layer_camera.h: positive, and greater in front; no two depths of a pixel are equal.
  std::vector<float> depth;
  std::vector<Rgba8> color;
  // The normals and the triangle numbers: either one for each sample, or empty if they were not
  // wanted. A triangle's number is as in Framebuffer::id; 0: none.
  std::vector<SampleNormal> normal;
  std::vector<std::uint32_t> triangle;

  // The index in `first` of pixel (x, y), y down.
  std::size_t pixel_index(int x, int y) const {
    return std::size_t(camera.height - 1 - y) * std::size_t(camera.width) + std::size_t(x);
  }
  std::size_t samples() const { return depth.size(); }
};

// Checks what drawing relies on: one offset for each pixel and one more, ascending to the number of
// samples; finite depths above 0 that ascend within a pixel; normals of the right length; an
// invertible camera. The error names `source` and the pixel.
Result<void> check(const LayeredImage& image, const std::string& source);

struct LayerCounts {
  std::size_t samples = 0;
  std::size_t covered = 0;  // pixels with at least one sample
  std::size_t most = 0;     // largest number of samples in one pixel
  // Samples per covered pixel; 0 if no pixel is covered.
  double complexity() const { return covered == 0 ? 0 : double(samples) / double(covered); }
};
LayerCounts count_layers(const LayeredImage& image);

}  // namespace glassbox::views
