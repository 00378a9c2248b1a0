#include "views/texture/static_texture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <glassbox/mesh/gltf/write.h>

namespace glassbox::views {

namespace {

// The corners of a triangle in its square of texels, as middles of texels. Two triangles share a
// square: the even one begins at the first texel, the odd one at the opposite corner. Interpolation
// uses the four texels around a place. For a place of either triangle, none of them is on the
// diagonal between the two triangles.
std::array<Vector2d, 3> patch_of(std::size_t triangle, int texels) {
  const double leg = texels - 3, end = texels - 1;
  if (triangle % 2 == 0) return {Vector2d(0, 0), Vector2d(leg, 0), Vector2d(0, leg)};
  return {Vector2d(end, end), Vector2d(end - leg, end), Vector2d(end, end - leg)};
}

class Atlas {
public:
  Atlas(std::size_t triangles, int texels)
      : texels_(texels),
        columns_(std::max(1, int(std::ceil(std::sqrt(double((triangles + 1) / 2)))))) {
    rows_ =
        std::max(1, int(((triangles + 1) / 2 + std::size_t(columns_) - 1) / std::size_t(columns_)));
  }
  int width() const { return columns_ * texels_; }
  int height() const { return rows_ * texels_; }
  // The first texel of the square that holds the triangle.
  std::array<int, 2> corner(std::size_t triangle) const {
    const std::size_t square = triangle / 2, columns = std::size_t(columns_);
    return {int(square % columns) * texels_, int(square / columns) * texels_};
  }

private:
  int texels_, columns_, rows_ = 1;
};

}  // namespace

double static_texture_bytes(std::size_t triangles, int texels) {
  // Texels, once as they are and twice while they are packed; for each triangle a face and three
  // corners with their positions and coordinates.
  constexpr double kTriangle = sizeof(Face) + 3 * (sizeof(Corner) + sizeof(float) * 5);
  const Atlas atlas(triangles, texels);
  return 3 * 4.0 * atlas.width() * atlas.height() +
         double(triangles) * (kTriangle + kGlbBytesOfTriangle);
}

Result<Scene> with_static_texture(const Scene& scene, const TexturedSurface& surface, int texels,
                                  double most_bytes) {
  const std::vector<WorldTriangle> triangles = world_triangles(scene);
  const Atlas atlas(triangles.size(), texels);
  constexpr int kMaxSide = 16384;
  const auto refused = [&](const std::string& cause, const char* remedy) {
    return fail("--texels",
                fmt::format("{} triangles, each pair in a square of {} texels along a side, need a "
                            "texture of {} x {} texels{}",
                            triangles.size(), texels, atlas.width(), atlas.height(), cause),
                remedy);
  };
  if (atlas.width() > kMaxSide || atlas.height() > kMaxSide)
    return refused(fmt::format(", but a side can have at most {}", kMaxSide),
                   "ask for fewer texels");
  const double bytes = static_texture_bytes(triangles.size(), texels);
  if (bytes > most_bytes)
    return refused(
        fmt::format(", and {:.0f} MB of memory in all, more than is allowed", bytes / 1048576),
        "ask for fewer texels, or allow more with --max-mb");
  Image<Rgba8> image(atlas.width(), atlas.height(), Rgba8{128, 128, 128, 255});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const WorldTriangle& triangle = triangles[i];
    const auto& c = triangle.corners;
    const Vector3d normal = triangle.normal();
    TexturedSurface::ColorsFromDirection from(
        surface, normal.norm() > 0 ? Vector3d(normal.normalized()) : Vector3d(0, 0, 1));
    const auto [left, top] = atlas.corner(i);
    const bool is_first = i % 2 == 0;
    for (int row = 0; row < texels; ++row) {
      for (int column = 0; column < texels; ++column) {
        const int u = is_first ? column : texels - 1 - column,
                  v = is_first ? row : texels - 1 - row;
        if (u + v > texels - 2) continue;
        // Texels outside of the triangle get the colour of the nearest point on its side.
        const double leg = texels - 3, s = u / leg, t = v / leg, over = std::max(1.0, s + t);
        const Vector3d world = c[0] + (s / over) * (c[1] - c[0]) + (t / over) * (c[2] - c[0]);
        const auto color = from.color_of(triangle, world);
        const auto byte = [&](int k) {
          if (!color) return triangle.color[std::size_t(k)];
          return std::uint8_t(std::floor(std::clamp((*color)[k], 0.0, 255.0) + 0.5));
        };
        image.at(left + column, top + row) = {byte(0), byte(1), byte(2), 255};
      }
    }
  }
  Scene textured = scene;
  textured.meshes.clear();
  textured.instances.clear();
  textured.nodes = {Node{}};
  Mesh mesh;
  mesh.name = "textured";
  mesh.faces.reserve(triangles.size());
  mesh.positions.reserve(3 * triangles.size());
  mesh.texcoords.reserve(3 * triangles.size());
  mesh.corners.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
    const auto patch = patch_of(i, texels);
    const auto corner = atlas.corner(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = std::uint32_t(mesh.positions.size());
      const Vector3d& p = triangles[i].corners[k];
      mesh.positions.push_back({float(p.x()), float(p.y()), float(p.z())});
      mesh.texcoords.push_back({float((corner[0] + patch[k].x() + 0.5) / atlas.width()),
                                float((corner[1] + patch[k].y() + 0.5) / atlas.height())});
      mesh.corners.push_back({index, kNone, index, kNone});
    }
  }
  textured.meshes.push_back(std::move(mesh));
  textured.instances.push_back({0, 0});
  Sampler sampler;
  sampler.wrap_u = sampler.wrap_v = Wrap::kClampToEdge;
  sampler.mip = MipFilter::kNone;
  textured.images = {std::move(image)};
  textured.textures = {{0, sampler}};
  Material material;
  material.unlit = true;
  material.texture = 0;
  textured.materials = {material};
  return textured;
}

}  // namespace glassbox::views
