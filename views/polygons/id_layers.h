// Layered images of polygons: in each pixel all surfaces on its line of sight, with how far they are and which polygon they belong to
// (S1-39). Colours are not stored: who asks for them looks into the picture. Polygons come and go, and what was behind one that
// goes is there at once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "views/two_view/camera.h"

namespace glassbox::views {

using PolygonId = std::uint32_t;

struct IdSample {
  float distance = 0;  // along the gaze, world units
  PolygonId id = 0;
  friend bool operator==(const IdSample&, const IdSample&) = default;
  friend auto operator<=>(const IdSample&, const IdSample&) = default;
};

// Nearest first, of equally near ones the lower id.
using IdSamples = std::vector<IdSample>;

using Corners3d = std::array<Vector3d, 3>;

// A pixel of a picture, rows from the top.
struct IdPixel {
  int x = 0, y = 0;
};

// A triangle of the world in a picture: its pixels, and how far it is there. Corners are snapped to 1/256 px and the pixels whose centres
// are inside counted, by integers; of two triangles with a common side a centre on it belongs to one. The distance at a pixel comes from
// the triangle alone, so it is the same whenever it is asked.
class PolygonFootprint {
public:
  // Nothing of a triangle that is turned away from the camera, not wholly before it, or beyond 2^15 px.
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

  int left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;  // empty where nothing is drawn
  std::array<std::int64_t, 3> x_{}, y_{};  // 1/256 px, counter-clockwise as y grows downwards
  std::array<double, 3> nearness_{};       // 1 / distance
  std::int64_t area_ = 0;
};

class IdLayers {
public:
  IdLayers(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // A polygon that is not there yet comes, or one that is there goes, whose footprint is that with which it came.
  void add(PolygonId id, const PolygonFootprint& footprint);
  void remove(PolygonId id, const PolygonFootprint& footprint);

  // What is seen there; none where nothing is.
  const IdSample* front(IdPixel at) const {
    const IdSamples& here = pixels_[index(at)];
    return here.empty() ? nullptr : &here.front();
  }
  const IdSamples& samples(IdPixel at) const { return pixels_[index(at)]; }
  std::int64_t sample_count() const;
  // What they take, a list for each pixel and the samples of those that have some.
  double bytes() const { return empty_bytes(width_, height_) + bytes_of_samples_; }
  static double empty_bytes(int width, int height) {
    return double(width) * height * double(sizeof(IdSamples));
  }
  // The list of a pixel with one or two samples: what the allocator keeps for it, too.
  static constexpr double kBytesOfPixel = 16 + 2 * sizeof(IdSample);

  // Of the same samples, however much room there is for more.
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
