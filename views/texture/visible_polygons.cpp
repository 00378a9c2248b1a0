#include "views/texture/visible_polygons.h"

#include <algorithm>
#include <cmath>

namespace glassbox::views {

Result<VisiblePolygons> VisiblePolygons::find(const Scene& scene, const PictureSet& set,
                                              UnlitRenderer& renderer) {
  VisiblePolygons seen(set.pictures.size(), triangle_number_count(scene));
  for (std::size_t view = 0; view < set.pictures.size(); ++view) {
    const CalibratedPicture& picture = set.pictures[view];
    auto buffers = renderer.draw(picture.camera, picture.color.width, picture.color.height);
    if (!buffers) return tl::unexpected(buffers.error());
    for (const std::uint32_t id : buffers->id.pixels) {
      if (id == 0) continue;
      const std::size_t i = view * seen.polygons_ + (id - 1);
      seen.bits_[i / 64] |= std::uint64_t(1) << (i % 64);
    }
    seen.distances_.push_back(std::move(buffers->distance));
  }
  return seen;
}

std::int64_t VisiblePolygons::unseen() const {
  std::int64_t unseen = 0;
  for (std::uint32_t polygon = 0; polygon < polygons_; ++polygon) {
    bool is_seen = false;
    for (std::size_t view = 0; view < views_ && !is_seen; ++view) is_seen = sees(view, polygon);
    unseen += !is_seen;
  }
  return unseen;
}

std::optional<Vector3d> VisiblePolygons::sample(std::size_t view, const CalibratedPicture& picture,
                                                const WorldTriangle& polygon,
                                                const Vector3d& world) const {
  const PinholeCamera& camera = picture.camera;
  const Vector3d at = project(camera, world);
  const int width = picture.color.width, height = picture.color.height;
  if (!(at.z() > 0) || !(at.x() >= 0 && at.x() <= width) || !(at.y() >= 0 && at.y() <= height))
    return std::nullopt;
  const double slack = 2 * at.z() / std::min(camera.intrinsic(0, 0), camera.intrinsic(1, 1));
  const Vector3d normal = camera.camera_from_world * polygon.normal();
  const double offset = normal.dot(camera.camera_from_world * (world - camera.centre));
  const auto shows_it = [&](int u, int v) {
    if (!picture.matte.pixels.empty() && picture.matte.at(u, v) == 0) return false;
    const double distance = distances_[view].at(u, v);
    if (std::abs(distance - at.z()) <= slack) return true;
    const Vector3d ray = ray_through(camera.intrinsic, {u + 0.5, v + 0.5});
    return std::abs(distance - offset / normal.dot(ray)) <= slack;
  };
  const double x = at.x() - 0.5, y = at.y() - 0.5, left = std::floor(x), top = std::floor(y);
  Vector3d sum = Vector3d::Zero();
  double weights = 0;
  for (int k = 0; k < 4; ++k) {
    const int column = int(left) + (k & 1), row = int(top) + (k >> 1);
    const double weight =
        ((k & 1) != 0 ? x - left : 1 - (x - left)) * ((k >> 1) != 0 ? y - top : 1 - (y - top));
    const int u = std::clamp(column, 0, width - 1), v = std::clamp(row, 0, height - 1);
    if (!shows_it(u, v)) continue;
    const Rgba8& color = picture.color.at(u, v);
    sum += weight * Vector3d(color.r, color.g, color.b);
    weights += weight;
  }
  // If the sum of the weights is only a rounding error, the pixels that show the surface are on the
  // far side of a border.
  if (!(weights > 0x1p-20)) return std::nullopt;
  return sum / weights;
}

double VisiblePolygons::bytes_for(const Scene& scene, const PictureSet& set) {
  double bytes = double(triangle_number_count(scene)) * double(set.pictures.size()) / 8;
  for (const CalibratedPicture& picture : set.pictures)
    bytes += double(picture.color.pixels.size() * sizeof(float));
  return bytes;
}

}  // namespace glassbox::views
