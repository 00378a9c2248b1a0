// Packing, merging, warping and splatting of layered depth images as beginners first write it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/LU>

#include <glassbox/images/image.h>

#include "views/layers/draw_layers.h"
#include "views/layers/layered_image.h"

namespace glassbox::study::naive {

// ---- the loop over all samples ----

// How the samples of a layered depth image are drawn, in double. Each member has the right value
// until a mutant (deliberately wrong code) changes it.
struct SplatLoop {
  // The side in px of the square that is drawn for a sample. w is the sample's distance from the
  // second eye divided by its distance from the first; `zoom` is the second focal length divided by
  // the first.
  std::function<double(double zoom, double w)> side = [](double zoom, double w) {
    return std::clamp(zoom / w, 1.0, double(views::kLargestSplat));
  };
  std::function<bool(double z, double w)> is_drawn = [](double z, double w) {
    return w > 0 && z <= 1;
  };
  bool compares_depth = true;
  // The order of the samples in a pixel.
  bool back_to_front = true;
  // The order in which columns and rows are visited; if empty, the order in which they are packed.
  std::vector<int> columns = {}, rows = {};
};

struct SplatPicture {
  Image<Rgba8> color;
  Image<double> depth;  // 0 where nothing was drawn
};

inline SplatPicture splat(const views::LayeredImage& image, const views::LayerCamera& to,
                          const SplatLoop& loop, double zoom = 1) {
  SplatPicture picture{Image<Rgba8>(to.width, to.height, Rgba8{0, 0, 0, 0}),
                       Image<double>(to.width, to.height, 0.0)};
  const Eigen::Matrix4d warp = views::warp_matrix(to, image.camera);
  const auto draw = [&](int x, int y, std::size_t i) {
    const Eigen::Vector4d at = warp * Eigen::Vector4d(x + 0.5, y + 0.5, double(image.depth[i]), 1);
    const double w = at.w(), z = at.z() / w;
    if (!loop.is_drawn(z, w)) return;
    const double half = loop.side(zoom, w) / 2;
    const auto pixel = [](double edge, int end) {
      return int(std::clamp(std::floor(edge + 0.5), 0.0, double(end)));
    };
    const double column = at.x() / w, row = at.y() / w;
    if (!std::isfinite(column) || !std::isfinite(row)) return;
    for (int v = pixel(row - half, to.height); v < pixel(row + half, to.height); ++v) {
      for (int u = pixel(column - half, to.width); u < pixel(column + half, to.width); ++u) {
        if (loop.compares_depth && !(z > picture.depth.at(u, v))) continue;
        picture.depth.at(u, v) = z;
        picture.color.at(u, v) = image.color[i];
      }
    }
  };
  const auto order = [](const std::vector<int>& asked, int count, bool ascending) {
    std::vector<int> all = asked;
    for (int i = 0; all.size() < std::size_t(count); ++i)
      all.push_back(ascending ? i : count - 1 - i);
    return all;
  };
  const auto columns = order(loop.columns, image.camera.width, true);
  for (const int y : order(loop.rows, image.camera.height, false)) {
    for (const int x : columns) {
      const std::size_t place = image.pixel_index(x, y);
      const std::size_t begin = image.first[place], end = image.first[place + 1];
      for (std::size_t k = begin; k < end; ++k)
        draw(x, y, loop.back_to_front ? k : begin + end - 1 - k);
    }
  }
  return picture;
}

// ---- merging ----

// Merges while the list of a pixel is built: each new depth is merged with the first one in the
// list whose relative difference from it is at most epsilon. The result depends on the order in
// which the depths arrive.
inline std::vector<float> merged_as_they_come(const std::vector<float>& depths, double epsilon) {
  std::vector<float> kept;
  for (const float depth : depths) {
    const auto near = std::ranges::find_if(kept, [&](float other) {
      return std::abs(double(other) - double(depth)) <= epsilon * double(std::max(other, depth));
    });
    if (near == kept.end()) {
      kept.push_back(depth);
    } else {
      *near = std::max(*near, depth);
    }
  }
  std::ranges::sort(kept);
  return kept;
}

// Sorts, then compares each depth with its neighbour, even if that one has been merged itself: a
// chain of depths, each near to the next, becomes a single sample, however long it is.
inline std::vector<float> merged_along_the_chain(std::vector<float> depths, double epsilon) {
  std::ranges::sort(depths, std::greater<>());
  std::vector<float> kept;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (i == 0 || double(depths[i - 1]) - double(depths[i]) > epsilon * double(depths[i - 1]))
      kept.push_back(depths[i]);
  }
  std::ranges::sort(kept);
  return kept;
}

// Keeps the farthest of the depths that are merged instead of the nearest, so surfaces move away
// from the eye.
inline std::vector<float> merged_from_behind(std::vector<float> depths, double epsilon) {
  std::ranges::sort(depths);
  std::vector<float> kept;
  for (const float depth : depths) {
    if (kept.empty() || double(depth) - double(kept.back()) > epsilon * double(depth))
      kept.push_back(depth);
  }
  return kept;
}

// ---- packing ----

// The depths in each pixel, from back to front; the pixels are in packed order.
using PixelLists = std::vector<std::vector<float>>;

struct Packed {
  std::vector<std::uint32_t> first;
  std::vector<float> depth;
};

// Stores the number of samples per pixel in a byte: 256 samples become 0.
inline Packed packed_by_byte_counts(const PixelLists& pixels) {
  Packed packed;
  std::uint32_t next = 0;
  for (const std::vector<float>& here : pixels) {
    packed.first.push_back(next);
    next += std::uint8_t(here.size());
    packed.depth.insert(packed.depth.end(), here.begin(), here.end());
  }
  packed.first.push_back(next);
  return packed;
}

// Stores an offset only for pixels that have samples; the offsets of empty pixels stay 0.
inline Packed packed_without_empty_pixels(const PixelLists& pixels) {
  Packed packed;
  packed.first.assign(pixels.size() + 1, 0);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i].empty()) continue;
    packed.first[i] = std::uint32_t(packed.depth.size());
    packed.depth.insert(packed.depth.end(), pixels[i].begin(), pixels[i].end());
  }
  packed.first.back() = std::uint32_t(packed.depth.size());
  return packed;
}

// Stores the index of each pixel's last sample, as if every pixel had one: for an empty first pixel
// it is minus one.
inline Packed packed_by_last_samples(const PixelLists& pixels) {
  Packed packed;
  for (const std::vector<float>& here : pixels) {
    packed.depth.insert(packed.depth.end(), here.begin(), here.end());
    packed.first.push_back(std::uint32_t(packed.depth.size()) - 1);
  }
  packed.first.push_back(std::uint32_t(packed.depth.size()));
  return packed;
}

}  // namespace glassbox::study::naive
