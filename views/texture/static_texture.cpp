#include "views/texture/static_texture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <glassbox/images/srgb.h>
#include <glassbox/mesh/triangulate.h>

namespace glassbox::views {

namespace {

struct Placed {
  std::array<Vector3d, 3> corners;  // world
  Vector3d color;                   // its own, levels: the mean of its corners'
  std::uint32_t number = 0;         // of the scene's triangles
};

// The triangles in the order of the scene, as it is drawn.
std::vector<Placed> placed_triangles(const Scene& scene) {
  std::vector<Placed> all;
  std::uint32_t first = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const auto& m = scene.nodes[instance.node].world_from_node;
    const Rgba& base = scene.materials[mesh.material].base_color;
    const Triangulation triangulation = triangulate(mesh);
    for (const Triangle& triangle : triangulation.triangles) {
      Placed placed;
      placed.number = first + triangle.number;
      Vector3d light = Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& corner = mesh.corners[triangle.corners[k]];
        const auto& p = mesh.positions[corner.position];
        for (int row = 0; row < 3; ++row)
          placed.corners[k][row] = double(m.at(row, 0)) * double(p.x) +
                                   double(m.at(row, 1)) * double(p.y) +
                                   double(m.at(row, 2)) * double(p.z) + double(m.at(row, 3));
        const Rgba own = corner.color == kNone ? Rgba{} : mesh.colors[corner.color];
        light +=
            Vector3d(double(own.r * base.r), double(own.g * base.g), double(own.b * base.b)) / 3;
      }
      for (int c = 0; c < 3; ++c) placed.color[c] = encode_srgb(float(light[c]));
      all.push_back(placed);
    }
    first += triangulation.numbered;
  }
  return all;
}

// Where the corners of a triangle are in its square of texels, at middles of texels: the first three of one triangle and, from the other end, of
// the next. Between the two lies a diagonal that neither's four texels around a place touch.
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
  // The first texel of a triangle's square.
  std::array<int, 2> corner(std::size_t triangle) const {
    const std::size_t square = triangle / 2, columns = std::size_t(columns_);
    return {int(square % columns) * texels_, int(square / columns) * texels_};
  }

private:
  int texels_, columns_, rows_ = 1;
};

Vector3d blended(const ViewWeights& weights, const PictureSet& set, const Vector3d& world,
                 const Vector3d& otherwise) {
  Vector3d sum = Vector3d::Zero();
  double all = 0;
  for (const ViewWeight& each : weights) {
    const auto color = TexturedSurface::sample(set.pictures[each.view], world);
    if (!color) continue;
    sum += each.weight * *color;
    all += each.weight;
  }
  return all > 0 ? Vector3d(sum / all) : otherwise;
}

}  // namespace

Result<Scene> with_static_texture(const Scene& scene, const PictureSet& set,
                                  const TexturedSurface& surface, int texels) {
  const std::vector<Placed> triangles = placed_triangles(scene);
  const Atlas atlas(triangles.size(), texels);
  constexpr int kMostSide = 16384;
  if (atlas.width() > kMostSide || atlas.height() > kMostSide) {
    return fail("--texels",
                fmt::format("{} triangles of {} texels take a texture of {} x {}", triangles.size(),
                            texels, atlas.width(), atlas.height()),
                "ask for fewer texels");
  }
  Image<Rgba8> image(atlas.width(), atlas.height(), Rgba8{128, 128, 128, 255});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& c = triangles[i].corners;
    const Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
    const ViewWeights weights =
        surface.blend()
            .from(normal.norm() > 0 ? Vector3d(normal.normalized()) : Vector3d(0, 0, 1))
            .weights(
                [&](std::size_t view) { return surface.seen().sees(view, triangles[i].number); });
    const auto [left, top] = atlas.corner(i);
    const bool is_first = i % 2 == 0;
    for (int row = 0; row < texels; ++row) {
      for (int column = 0; column < texels; ++column) {
        const int u = is_first ? column : texels - 1 - column,
                  v = is_first ? row : texels - 1 - row;
        if (u + v > texels - 2) continue;
        // Texels beside the triangle have what is on its side.
        const double leg = texels - 3, s = u / leg, t = v / leg, over = std::max(1.0, s + t);
        const Vector3d world = c[0] + (s / over) * (c[1] - c[0]) + (t / over) * (c[2] - c[0]);
        const Vector3d color = blended(weights, set, world, triangles[i].color);
        const auto byte = [&](int k) {
          return std::uint8_t(std::floor(std::clamp(color[k], 0.0, 255.0) + 0.5));
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
