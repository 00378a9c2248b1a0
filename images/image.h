// Images: rows of pixels, top row first.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glassbox/base/cache_aligned_vector.h>

namespace glassbox {

// Eight bits a channel, as stored in files: sRGB-encoded colour (unless rendered with --transfer
// none), alpha linear.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

// A pixel of three floats, for PFM files.
struct Rgb32f {
  float r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb32f&, const Rgb32f&) = default;
};

template <class Pixel>
struct Image {
  int width = 0;   // px
  int height = 0;  // px
  // width * height pixels, row by row from the top. The data begin at the start of a cache line. If
  // the width is a multiple of a cache line, every row does, so that the rows of a tile can be
  // written as whole lines.
  CacheAlignedVector<Pixel> pixels;

  Image() = default;
  Image(int width_, int height_, Pixel fill = {})
      : width(width_), height(height_), pixels(std::size_t(width_) * std::size_t(height_), fill) {}

  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
  Pixel& at(int x, int y) { return pixels[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }
  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace glassbox
