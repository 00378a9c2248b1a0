#include "views/polygons/id_layers.h"

#include <algorithm>
#include <cmath>

namespace glassbox::views {

namespace {

constexpr double kSubpixels = 256;
// px; for snapped corners within this distance, differences of two products of differences of
// coordinates (in 1/256 px) stay below 2^49.
constexpr double kFarthest = 0x1p15;

std::int64_t snapped(double pixels) {
  return std::int64_t(std::floor(pixels * kSubpixels + 0.5));
}

// For a coordinate in 1/256 px: first_centre() is the first pixel whose centre is at or after it,
// end_centre() is one after the last pixel whose centre is at or before it.
int first_centre(std::int64_t subpixels) {
  return int((subpixels + 127) >> 8);
}
int end_centre(std::int64_t subpixels) {
  return int((subpixels - 128) >> 8) + 1;
}

// Whether the pixel centres on a side belong to the triangle: on a left or a top side they do. y
// grows downwards, and the inside is to the right of a side that runs from (0, 0) to (dx, dy): a
// left side goes up, a top side to the right.
bool owns_its_centres(std::int64_t dx, std::int64_t dy) {
  return dy < 0 || (dy == 0 && dx > 0);
}

double bytes_of(const IdSamples& samples) {
  constexpr double kAllocators = IdLayers::kBytesOfPixel - 2 * sizeof(IdSample);
  if (samples.capacity() == 0) return 0;
  return kAllocators + double(std::max<std::size_t>(samples.capacity(), 2) * sizeof(IdSample));
}

}  // namespace

PolygonFootprint::PolygonFootprint(const PinholeCamera& camera, int width, int height,
                                   const Corners3d& corners) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d p = project(camera, corners[i]);
    if (!(p.z() > 0) || !(std::abs(p.x()) < kFarthest) || !(std::abs(p.y()) < kFarthest)) return;
    x_[i] = snapped(p.x());
    y_[i] = snapped(p.y());
    nearness_[i] = 1 / p.z();
  }
  // Counter-clockwise as seen by the camera means a negative cross product in coordinates whose y
  // grows downwards.
  area_ = (x_[1] - x_[0]) * (y_[2] - y_[0]) - (x_[2] - x_[0]) * (y_[1] - y_[0]);
  if (area_ >= 0) return;
  area_ = -area_;
  std::swap(x_[1], x_[2]);
  std::swap(y_[1], y_[2]);
  std::swap(nearness_[1], nearness_[2]);
  const auto [low_x, high_x] = std::minmax({x_[0], x_[1], x_[2]});
  const auto [low_y, high_y] = std::minmax({y_[0], y_[1], y_[2]});
  left_ = std::clamp(first_centre(low_x), 0, width);
  right_ = std::clamp(end_centre(high_x), left_, width);
  top_ = std::clamp(first_centre(low_y), 0, height);
  bottom_ = std::clamp(end_centre(high_y), top_, height);
}

std::optional<float> PolygonFootprint::distance_at(int x, int y) const {
  const std::int64_t px = 256 * std::int64_t(x) + 128, py = 256 * std::int64_t(y) + 128;
  double nearness = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = (i + 1) % 3, to = (i + 2) % 3;
    const std::int64_t dx = x_[to] - x_[from], dy = y_[to] - y_[from];
    const std::int64_t edge = dx * (py - y_[from]) - dy * (px - x_[from]);
    if (edge < 0 || (edge == 0 && !owns_its_centres(dx, dy))) return std::nullopt;
    nearness += double(edge) * nearness_[i];
  }
  return float(double(area_) / nearness);
}

IdLayers::IdLayers(int width, int height)
    : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height)) {}

void IdLayers::add(PolygonId id, const PolygonFootprint& footprint) {
  footprint.for_each_pixel([&](IdPixel at, float distance) {
    IdSamples& here = pixels_[index(at)];
    const IdSample sample{distance, id};
    const double before = bytes_of(here);
    here.insert(std::ranges::lower_bound(here, sample), sample);
    bytes_of_samples_ += bytes_of(here) - before;
  });
}

void IdLayers::remove(PolygonId id, const PolygonFootprint& footprint) {
  footprint.for_each_pixel([&](IdPixel at, float distance) {
    IdSamples& here = pixels_[index(at)];
    const IdSample sample{distance, id};
    const auto found = std::ranges::lower_bound(here, sample);
    if (found != here.end() && *found == sample) here.erase(found);
  });
}

std::int64_t IdLayers::sample_count() const {
  std::int64_t samples = 0;
  for (const IdSamples& here : pixels_) samples += std::int64_t(here.size());
  return samples;
}

}  // namespace glassbox::views
