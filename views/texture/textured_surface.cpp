#include "views/texture/textured_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/render/renderer.h>

namespace glassbox::views {

namespace {

RenderSettings plain_settings(Rgba8 background) {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.background = background;
  settings.want_id = true;
  settings.want_distance = true;
  return settings;
}

// Triangles are numbered through all instances, in the order in which they are drawn.
std::size_t triangles_of(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Instance& instance : scene.instances) {
    for (const Face& face : scene.meshes[instance.mesh].faces)
      triangles += face.count - std::min(face.count, 2u);
  }
  return triangles;
}

std::uint8_t level(double value) {
  return std::uint8_t(std::floor(std::clamp(value, 0.0, 255.0) + 0.5));
}

}  // namespace

Result<SeenPolygons> SeenPolygons::of(const Scene& scene, const PictureSet& set) {
  SeenPolygons seen(set.pictures.size(), triangles_of(scene));
  const WorldBox box = box_of(scene);
  const RenderSettings settings = plain_settings({0, 0, 0, 255});
  Renderer renderer(scene, settings.transfer);
  for (std::size_t view = 0; view < set.pictures.size(); ++view) {
    const CalibratedPicture& picture = set.pictures[view];
    const auto camera = view_of(picture.camera, picture.color.width, picture.color.height, box);
    if (!camera) return tl::unexpected(camera.error());
    for (const std::uint32_t id : renderer.render(*camera, settings).buffers.id.pixels) {
      if (id == 0) continue;
      const std::size_t i = view * seen.polygons_ + (id - 1);
      seen.bits_[i / 64] |= std::uint64_t(1) << (i % 64);
    }
  }
  return seen;
}

std::int64_t SeenPolygons::unseen() const {
  std::int64_t unseen = 0;
  for (std::uint32_t polygon = 0; polygon < polygons_; ++polygon) {
    bool is_seen = false;
    for (std::size_t view = 0; view < views_ && !is_seen; ++view) is_seen = sees(view, polygon);
    unseen += !is_seen;
  }
  return unseen;
}

Result<TexturedSurface> TexturedSurface::of(const Scene& scene, const PictureSet& set, Blend blend,
                                            int neighbours) {
  if (triangles_of(scene) == 0)
    return fail("the mesh", "it has no polygons",
                "give one with faces, as `glassbox views polygons` writes it");
  auto seen = SeenPolygons::of(scene, set);
  if (!seen) return tl::unexpected(seen.error());
  const WorldBox box = box_of(scene);
  const Vector3d middle = (box.low + box.high) / 2;
  std::vector<Vector3d> directions;
  for (const CalibratedPicture& picture : set.pictures)
    directions.push_back((picture.camera.centre - middle).normalized());
  return TexturedSurface(scene, set, std::move(*seen), ViewBlend(blend, directions, neighbours),
                         middle);
}

std::optional<Vector3d> TexturedSurface::sample(const CalibratedPicture& picture,
                                                const Vector3d& world) {
  const Vector3d at = project(picture.camera, world);
  const int width = picture.color.width, height = picture.color.height;
  if (!(at.z() > 0) || !(at.x() >= 0 && at.x() <= width) || !(at.y() >= 0 && at.y() <= height))
    return std::nullopt;
  const double x = at.x() - 0.5, y = at.y() - 0.5, left = std::floor(x), top = std::floor(y);
  Vector3d sum = Vector3d::Zero();
  double weights = 0;
  for (int k = 0; k < 4; ++k) {
    const int column = int(left) + (k & 1), row = int(top) + (k >> 1);
    const double weight =
        ((k & 1) != 0 ? x - left : 1 - (x - left)) * ((k >> 1) != 0 ? y - top : 1 - (y - top));
    const int u = std::clamp(column, 0, width - 1), v = std::clamp(row, 0, height - 1);
    if (!picture.matte.pixels.empty() && picture.matte.at(u, v) == 0) continue;
    const Rgba8& color = picture.color.at(u, v);
    sum += weight * Vector3d(color.r, color.g, color.b);
    weights += weight;
  }
  // A sum of weights that is rounding alone has the object's pixels on the far side of a border.
  if (!(weights > 0x1p-20)) return std::nullopt;
  return sum / weights;
}

Result<TexturedPicture> TexturedSurface::draw(const PinholeCamera& camera, int width, int height,
                                              Rgba8 background) const {
  const auto view = view_of(camera, width, height, box_of(scene_));
  if (!view) return tl::unexpected(view.error());
  const RenderSettings settings = plain_settings(background);
  Renderer renderer(scene_, settings.transfer);
  Framebuffer buffers = renderer.render(*view, settings).buffers;
  TexturedPicture picture{std::move(buffers.color), std::move(buffers.id)};
  const Vector3d out = camera.centre - middle_;
  const ViewBlend::From from =
      blend_.from(out.norm() > 0 ? Vector3d(out.normalized()) : Vector3d(0, 0, 1));
  std::uint32_t last = 0;
  ViewWeights weights;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t id = picture.id.at(x, y);
      if (id == 0) continue;
      ++picture.surface;
      if (id != last) {
        weights = from.weights([&](std::size_t v) { return seen_.sees(v, id - 1); });
        last = id;
      }
      const Vector3d ray = ray_through(camera.intrinsic, {x + 0.5, y + 0.5});
      const Vector3d world = camera.centre + camera.camera_from_world.transpose() *
                                                 (double(buffers.distance.at(x, y)) * ray);
      Vector3d sum = Vector3d::Zero();
      double all = 0;
      for (const ViewWeight& each : weights) {
        const auto color = sample(set_.pictures[each.view], world);
        if (!color) continue;
        sum += each.weight * *color;
        all += each.weight;
      }
      if (!(all > 0)) {
        ++picture.without_view;
        continue;
      }
      const Vector3d color = sum / all;
      picture.color.at(x, y) = {level(color[0]), level(color[1]), level(color[2]), 255};
    }
  }
  return picture;
}

TextureErrors compare(const TexturedPicture& drawn, const CalibratedPicture& picture) {
  TextureErrors errors;
  double squares = 0;
  std::int64_t covered = 0;
  for (std::size_t i = 0; i < picture.color.pixels.size(); ++i) {
    const bool is_object = picture.matte.pixels.empty() || picture.matte.pixels[i] != 0;
    errors.pixels += is_object;
    if (!is_object || drawn.id.pixels[i] == 0) continue;
    ++covered;
    const Rgba8 &found = drawn.color.pixels[i], &right = picture.color.pixels[i];
    for (const int d : {found.r - right.r, found.g - right.g, found.b - right.b})
      squares += double(d * d);
  }
  errors.rms = covered > 0 ? std::sqrt(squares / (3 * double(covered)))
                           : std::numeric_limits<double>::quiet_NaN();
  errors.psnr = 20 * std::log10(255 / errors.rms);
  if (errors.pixels > 0) errors.covered = double(covered) / double(errors.pixels);
  return errors;
}

}  // namespace glassbox::views
