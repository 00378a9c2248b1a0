#include "views/texture/textured_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glassbox/base/elementary.h>

namespace glassbox::views {

namespace {

std::uint8_t level(double value) {
  return std::uint8_t(std::floor(std::clamp(value, 0.0, 255.0) + 0.5));
}

std::vector<std::size_t> indices_without(std::size_t count, std::optional<std::size_t> left_out) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < count; ++i) {
    if (i != left_out) all.push_back(i);
  }
  return all;
}

std::vector<Vector3d> directions_of(const PictureSet& set, const std::vector<std::size_t>& pictures,
                                    const Vector3d& middle) {
  std::vector<Vector3d> directions;
  for (const std::size_t i : pictures)
    directions.push_back((set.pictures[i].camera.centre - middle).normalized());
  return directions;
}

}  // namespace

TexturedSurface::TexturedSurface(std::shared_ptr<const Surface> surface, Blend blend,
                                 int neighbours, std::optional<std::size_t> left_out)
    : surface_(std::move(surface)),
      pictures_(indices_without(surface_->set.pictures.size(), left_out)),
      blend_(blend, directions_of(surface_->set, pictures_, surface_->middle), neighbours) {}

double TexturedSurface::bytes_for(const Scene& scene, const PictureSet& set) {
  return bytes_of(scene) + VisiblePolygons::bytes_for(scene, set) +
         2 * double(triangle_number_count(scene)) * sizeof(WorldTriangle);
}

Result<TexturedSurface> TexturedSurface::create(const Scene& scene, const PictureSet& set,
                                                Blend blend, int neighbours) {
  if (triangle_number_count(scene) == 0)
    return fail("the mesh", "it has no polygons",
                "give a mesh with faces, such as `glassbox views polygons` writes");
  auto renderer = std::make_unique<UnlitRenderer>(scene);
  auto seen = VisiblePolygons::find(scene, set, *renderer);
  if (!seen) return tl::unexpected(seen.error());
  // Indexed by polygon number. Numbers that no triangle has stay without corners; no pixel shows
  // them.
  std::vector<WorldTriangle> triangles(seen->polygons());
  for (const WorldTriangle& placed : world_triangles(scene)) triangles[placed.number] = placed;
  const WorldBox box = box_of(scene);
  auto surface =
      std::make_shared<const Surface>(Surface{scene, set, std::move(renderer), std::move(*seen),
                                              std::move(triangles), (box.low + box.high) / 2});
  return TexturedSurface(std::move(surface), blend, neighbours, {});
}

TexturedSurface TexturedSurface::with_blend(Blend blend, int neighbours,
                                            std::optional<std::size_t> left_out) const {
  return {surface_, blend, neighbours, left_out};
}

TexturedSurface::ColorsFromDirection::ColorsFromDirection(const TexturedSurface& surface,
                                                          const Vector3d& direction)
    : surface_(surface), from_(surface.blend_.from_direction(direction)) {}

std::optional<Vector3d> TexturedSurface::ColorsFromDirection::sample(std::size_t view,
                                                                     const WorldTriangle& polygon,
                                                                     const Vector3d& world) const {
  const std::size_t picture = surface_.pictures_[view];
  return surface_.visible_polygons().sample(picture, surface_.surface_->set.pictures[picture],
                                            polygon, world);
}

std::optional<Vector3d> TexturedSurface::ColorsFromDirection::color_of(const WorldTriangle& polygon,
                                                                       const Vector3d& world) {
  const auto sees_polygon = [&](std::size_t view) {
    return surface_.visible_polygons().sees(surface_.pictures_[view], polygon.number);
  };
  if (last_ != polygon.number) {
    weights_ = from_.weights(sees_polygon);
    last_ = polygon.number;
  }
  const auto blended = [&](const ViewWeights& weights) -> std::optional<Vector3d> {
    Vector3d sum = Vector3d::Zero();
    for (const ViewWeight& each : weights) {
      const auto color = sample(each.view, polygon, world);
      if (!color) return std::nullopt;
      sum += each.weight * *color;
    }
    return weights.empty() ? std::nullopt : std::optional(sum);
  };
  if (const auto color = blended(weights_); color || weights_.empty()) return color;
  return blended(from_.weights([&](std::size_t view) {
    return sees_polygon(view) && sample(view, polygon, world).has_value();
  }));
}

Result<TexturedPicture> TexturedSurface::draw(const PinholeCamera& camera, int width, int height,
                                              Rgba8 background) const {
  auto buffers = surface_->renderer->draw(camera, width, height, background);
  if (!buffers) return tl::unexpected(buffers.error());
  TexturedPicture picture{std::move(buffers->color), std::move(buffers->id)};
  const Vector3d out = camera.centre - middle();
  ColorsFromDirection from(*this, out.norm() > 0 ? Vector3d(out.normalized()) : Vector3d(0, 0, 1));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t id = picture.id.at(x, y);
      if (id == 0) continue;
      ++picture.surface;
      const Vector3d ray = ray_through(camera.intrinsic, {x + 0.5, y + 0.5});
      const Vector3d world = camera.centre + camera.camera_from_world.transpose() *
                                                 (double(buffers->distance.at(x, y)) * ray);
      const auto color = from.color_of(triangles()[id - 1], world);
      if (!color) {
        ++picture.without_view;
        continue;
      }
      picture.color.at(x, y) = {level((*color)[0]), level((*color)[1]), level((*color)[2]), 255};
    }
  }
  return picture;
}

TextureErrors textured_picture_errors(const TexturedPicture& drawn,
                                      const CalibratedPicture& picture) {
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
  errors.psnr = 20 * logarithm_10(255 / errors.rms);
  if (errors.pixels > 0) errors.covered = double(covered) / double(errors.pixels);
  return errors;
}

}  // namespace glassbox::views
