// Layered images of polygons: for each pixel all surfaces on its line of sight, with their
// distances and polygon numbers (S1-39). Colours are not stored; they are read from the picture.
// Polygons can be added and removed, and a polygon behind a removed one is in the list already.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "views/two_view/camera.h"

namespace glassbox::views {

using PolygonId = std::uint32_t;

struct IdSample {
  float distance = 0;  // along the direction of view, world units
  PolygonId id = 0;
  friend bool operator==(const IdSample&, const IdSample&) = default;
  friend auto operator<=>(const IdSample&, const IdSample&) = default;
};

// The samples of a pixel, nearest first; of equally near ones the lower id first.
using IdSamples = std::vector<IdSample>;

using Corners3d = std::array<Vector3d, 3>;

// A pixel of a picture; rows count from the top.
struct IdPixel {
  int x = 0, y = 0;
};

// A triangle of the world in a picture: its pixels, and its distance at each. Corners are snapped
// to 1/256 px, and the pixels whose centres are inside are found with integers; a centre on the
// common side of two triangles belongs to one of them. The distance at a pixel depends only on the
// triangle, so it is the same each time it is computed.
class PolygonFootprint {
public:
  // The footprint is empty for a triangle that is turned away from the camera, not entirely in
  // front of it, or beyond 2^15 px.
  PolygonFootprint(const PinholeCamera& camera, int width, int height, const Corners3d& corners);

  template <typename Visit>  // visit(IdPixel, float distance)
  void for_each_pixel(Visit&& visit) const {
    for (int y = top_; y < bottom_; ++y) {
      for (int x = left_; x < right_; ++x) {
        if (const std::optional<float> distance = distance_at(x, y))
          visit(IdPixel{x, y}, *distance);
      }
    }
  }

private:
  std::optional<float> distance_at(int x, int y) const;

  int left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;  // empty if nothing is drawn
  std::array<std::int64_t, 3> x_{}, y_{};  // 1/256 px, counter-clockwise where y grows downwards
  std::array<double, 3> nearness_{};       // 1 / distance
  std::int64_t area_ = 0;
};

class IdLayers {
public:
  IdLayers(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // Adds a polygon that is not in the layers, or removes one that is, with the footprint with which
  // it was added.
  void add(PolygonId id, const PolygonFootprint& footprint);
  void remove(PolygonId id, const PolygonFootprint& footprint);

  // The nearest sample of a pixel; nullptr if there is none.
  const IdSample* front(IdPixel at) const {
    const IdSamples& here = pixels_[index(at)];
    return here.empty() ? nullptr : &here.front();
  }
  const IdSamples& samples(IdPixel at) const { return pixels_[index(at)]; }
  std::int64_t sample_count() const;
  // Bytes of memory: a list for each pixel, and the samples of the pixels that have some.
  double bytes() const { return empty_bytes(width_, height_) + bytes_of_samples_; }
  static double empty_bytes(int width, int height) {
    return double(width) * height * double(sizeof(IdSamples));
  }
  // Bytes for the list of a pixel with one or two samples, the allocator's own data included.
  static constexpr double kBytesOfPixel = 16 + 2 * sizeof(IdSample);

  // Compares the samples, not the reserved memory.
  friend bool operator==(const IdLayers& a, const IdLayers& b) {
    return a.width_ == b.width_ && a.height_ == b.height_ && a.pixels_ == b.pixels_;
  }

private:
  std::size_t index(IdPixel at) const {
    return std::size_t(at.y) * std::size_t(width_) + std::size_t(at.x);
  }

  int width_, height_;
  std::vector<IdSamples> pixels_;
  double bytes_of_samples_ = 0;
};

}  // namespace glassbox::views
