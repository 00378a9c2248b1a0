#include "study/extremes/common/ray_scene.h"

#include <glm/matrix.hpp>

#include <glassbox/mesh/triangulate.h>
#include <glassbox/pipeline/look_at.h>

#include "exact/camera.h"
#include "study/extremes/common/drawn_coverage.h"

namespace glassbox::study {

namespace {

using Long = long double;
using Long3 = std::array<Long, 3>;

Long3 corner(const Point<Eye>& p) {
  return {Long(p.x), Long(p.y), Long(p.z)};
}

RayScene with_texcoords(const std::vector<EyeTriangle>& triangles,
                        const std::vector<Texcoords>& texcoords, const Lens& lens, int side) {
  RayScene ray_scene = make_ray_scene(triangles, lens, side);
  Mesh& mesh = ray_scene.scene.meshes[0];
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [u, v] = texcoords[i][k];
      mesh.corners[3 * i + k].texcoord = std::uint32_t(mesh.texcoords.size());
      mesh.texcoords.push_back({u, v});
      ray_scene.triangles[i].texcoords[k] = {double(u), double(v)};
    }
  }
  return ray_scene;
}

void set_texture(RayScene& ray_scene, Image<Rgba8> image, const Sampler& sampler) {
  ray_scene.scene.images.push_back(std::move(image));
  ray_scene.scene.textures.push_back({0, sampler});
  ray_scene.scene.materials[0].texture = 0;
}

void set_numbered_texels(RayScene& ray_scene, std::array<int, 2> texels, Wrap wrap) {
  ray_scene.texels = RayScene::Texels::kEach;
  Image<Rgba8> image(texels[0], texels[1]);
  for (int row = 0; row < texels[1]; ++row) {
    for (int column = 0; column < texels[0]; ++column) {
      image.at(column, row) = color_of_texel(column, row);
    }
  }
  set_texture(ray_scene, std::move(image),
              {wrap, wrap, Filter::kNearest, Filter::kNearest, MipFilter::kNone});
}

// A point in eye space, computed from its place in the world minus that of the camera.
Long3 in_eye_space(const Transform<World, Eye>& pose, const Transform<World, Object>& map,
                   const Point<Object>& p) {
  const Long3 object{Long(p.x), Long(p.y), Long(p.z)};
  Long3 eye{};
  for (int row = 0; row < 3; ++row) {
    Long world = Long(map.at(row, 3)) - Long(pose.at(row, 3));
    for (int k = 0; k < 3; ++k) world += Long(map.at(row, k)) * object[std::size_t(k)];
    for (int k = 0; k < 3; ++k) eye[std::size_t(k)] += Long(pose.at(row, k)) * world;
  }
  return eye;
}

}  // namespace

Rgba8 color_of_texel(int column, int row) {
  const auto high = std::uint8_t(64 | (column >> 8 & 15) | (row >> 8 & 3) << 4);
  return {std::uint8_t(column & 255), std::uint8_t(row & 255), high, 255};
}

RayScene make_ray_scene(const std::vector<EyeTriangle>& triangles, const Lens& lens, int side) {
  Mesh mesh;
  RayScene ray_scene;
  for (const EyeTriangle& t : triangles) {
    const auto object = [](const Point<Eye>& p) { return Point<Object>(p.x, p.y, p.z); };
    add_triangle(mesh, {object(t[0]), object(t[1]), object(t[2])});
    ray_scene.triangles.push_back({{corner(t[0]), corner(t[1]), corner(t[2])}, {}});
  }
  Camera camera;
  camera.lens = lens;
  ray_scene.scene = scene_of(std::move(mesh), unlit_material());
  ray_scene.lens = lens;
  ray_scene.view = make_view(camera, side, side).value();
  ray_scene.settings = plain_settings();
  return ray_scene;
}

RayScene textured_ray_scene(const std::vector<EyeTriangle>& triangles,
                            const std::vector<Texcoords>& texcoords, const Lens& lens, int side,
                            std::array<int, 2> texels, Wrap wrap) {
  RayScene ray_scene = with_texcoords(triangles, texcoords, lens, side);
  set_numbered_texels(ray_scene, texels, wrap);
  return ray_scene;
}

RayScene striped_ray_scene(const std::vector<EyeTriangle>& triangles,
                           const std::vector<Texcoords>& texcoords, const Lens& lens, int side,
                           int texels) {
  RayScene ray_scene = with_texcoords(triangles, texcoords, lens, side);
  ray_scene.texels = RayScene::Texels::kLevels;
  Image<Rgba8> image(texels, texels);
  for (int row = 0; row < texels; ++row) {
    for (int column = 0; column < texels; ++column) {
      const auto stripe = [&](int width) { return std::uint8_t(column / width % 2 * 255); };
      image.at(column, row) = {stripe(1), stripe(4), stripe(16), 255};
    }
  }
  set_texture(
      ray_scene, std::move(image),
      {Wrap::kRepeat, Wrap::kRepeat, Filter::kNearest, Filter::kNearest, MipFilter::kNearest});
  return ray_scene;
}

RayScene make_ray_scene(const Scene& scene, const Camera& camera, int width, int height) {
  RayScene ray_scene{
      scene, camera.lens, make_view(camera, width, height).value(), plain_settings(), {}};
  for (Material& material : ray_scene.scene.materials) material.unlit = true;
  for (Mesh& mesh : ray_scene.scene.meshes) {
    // Without the scene's own colours, which would disturb the count of layers.
    for (Corner& corner : mesh.corners) corner.color = kNone;
  }
  for (const Instance& instance : scene.instances) {
    const auto& map = scene.nodes[instance.node].world_from_node;
    const Mesh& mesh = scene.meshes[instance.mesh];
    const auto seen = [&](std::uint32_t corner) {
      return in_eye_space(camera.world_from_eye, map,
                          mesh.positions[mesh.corners[corner].position]);
    };
    const bool mirrored = glm::determinant(glm::dmat3(map.columns)) < 0;
    for (const Triangle& triangle : triangulate(mesh).triangles) {
      const auto& [a, b, c] = triangle.corners;
      ray_scene.triangles.push_back(
          {{seen(a), seen(mirrored ? c : b), seen(mirrored ? b : c)}, {}});
    }
  }
  return ray_scene;
}

namespace {

// Converts to 64 bits of mantissa; a double has only 53.
Long in_64_bits(const exact::Decimal& number) {
  const double high = double(number);
  return Long(high) + Long(double(number - exact::Decimal(high)));
}

Long3 aimed(const exact::Matrix4<exact::Decimal>& eye_from_world,
            const Transform<World, Object>& map, const Point<Object>& p) {
  const exact::Vector4<exact::Decimal> object{exact::Decimal(double(p.x)),
                                              exact::Decimal(double(p.y)),
                                              exact::Decimal(double(p.z)), exact::Decimal(1)};
  const auto eye = eye_from_world * (exact::exactly<exact::Decimal>(map) * object);
  return {in_64_bits(eye[0]), in_64_bits(eye[1]), in_64_bits(eye[2])};
}

}  // namespace

RayScene make_ray_scene(const Scene& scene, const Aim& aim, const Lens& lens, int side) {
  Camera camera;
  camera.lens = lens;
  camera.world_from_eye = camera_pose(aim.eye, aim.target, aim.up).value();
  RayScene ray_scene = make_ray_scene(scene, camera, side, side);
  const auto eye_from_world = exact::look_at(aim.eye, aim.target, aim.up);
  std::size_t number = 0;
  for (const Instance& instance : scene.instances) {
    const auto& map = scene.nodes[instance.node].world_from_node;
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const Triangle& triangle : triangulate(mesh).triangles) {
      ExactEyeTriangle& seen = ray_scene.triangles[number++];
      for (std::size_t k = 0; k < 3; ++k) {
        seen.corners[k] =
            aimed(eye_from_world, map, mesh.positions[mesh.corners[triangle.corners[k]].position]);
      }
    }
  }
  return ray_scene;
}

void store_depth(RayScene& ray_scene, DepthFormat format) {
  const bool reversed = format == DepthFormat::kFloat32Reversed;
  const Transform<Eye, World> eye_from_world = ray_scene.view.eye_from_world;
  Camera camera;
  camera.lens = ray_scene.lens;
  ray_scene.view =
      make_view(camera, int(ray_scene.view.viewport.width()), int(ray_scene.view.viewport.height()),
                reversed ? DepthRange::kReversed : DepthRange::kStandard)
          .value();
  ray_scene.view.eye_from_world = eye_from_world;
  ray_scene.settings.depth = format;
}

void add_numbered_texels(RayScene& ray_scene, std::array<int, 2> texels) {
  for (Mesh& mesh : ray_scene.scene.meshes) {
    mesh.texcoords.clear();
    for (const Point<Object>& p : mesh.positions) {
      mesh.texcoords.push_back({(p.x + 1) / 2, (p.y + 1) / 2});
    }
    for (Corner& corner : mesh.corners) corner.texcoord = corner.position;
  }
  std::size_t number = 0;
  for (const Instance& instance : ray_scene.scene.instances) {
    const Mesh& mesh = ray_scene.scene.meshes[instance.mesh];
    for (const Triangle& triangle : triangulate(mesh).triangles) {
      ExactEyeTriangle& seen = ray_scene.triangles[number++];
      for (std::size_t k = 0; k < 3; ++k) {
        const TexCoord& at = mesh.texcoords[mesh.corners[triangle.corners[k]].texcoord];
        seen.texcoords[k] = {double(at.u), double(at.v)};
      }
    }
  }
  set_numbered_texels(ray_scene, texels, Wrap::kRepeat);
}

Camera camera_at(const Point<World, double>& place, const Vector<World, double>& gaze) {
  Camera camera;
  camera.lens = PerspectiveLens{1, 0.1, 100.0};
  camera.world_from_eye = camera_pose(place, gaze, {0, 1, 0.01}).value();
  return camera;
}

}  // namespace glassbox::study
