#include <glassbox/mesh/builtin/placement.h>

#include <cmath>
#include <utility>

#include <glassbox/base/trig.h>

namespace glassbox {

Vector<World, double> unit(const Vector<World, double>& v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

Transform<World, Eye> look_at_pose(const Point<World, double>& eye,
                                   const Point<World, double>& target) {
  const Vector<World, double> up(0, 1, 0);
  const Vector<World, double> backward = unit(eye - target);
  const Vector<World, double> right = unit(cross(up, backward));
  const Vector<World, double> upward = cross(backward, right);
  Transform<World, Eye> pose;
  const std::array<Vector<World, double>, 4> columns = {
      right, upward, backward, {eye.x, eye.y, eye.z}};
  for (int column = 0; column < 4; ++column) {
    const Vector<World, double>& v = columns[std::size_t(column)];
    pose.at(0, column) = v.x;
    pose.at(1, column) = v.y;
    pose.at(2, column) = v.z;
  }
  return pose;
}

Transform<World, Object> placement_transform(const std::array<double, 3>& translation,
                                             double turn_degrees,
                                             const std::array<double, 3>& scale) {
  const SinCos turn = sin_cos_degrees(turn_degrees);
  Transform<World, Object> m;
  m.at(0, 0) = turn.cos * scale[0];
  m.at(0, 2) = turn.sin * scale[2];
  m.at(1, 1) = scale[1];
  m.at(2, 0) = -turn.sin * scale[0];
  m.at(2, 2) = turn.cos * scale[2];
  for (int row = 0; row < 3; ++row) m.at(row, 3) = translation[std::size_t(row)];
  return m;
}

std::uint32_t add_object(Scene& scene, Mesh mesh,
                         const Transform<World, Object>& world_from_object) {
  const auto index = std::uint32_t(scene.meshes.size());
  std::string name = mesh.name;
  scene.meshes.push_back(std::move(mesh));
  add_instance(scene, index, std::move(name), world_from_object);
  return index;
}

void add_instance(Scene& scene, std::uint32_t mesh, std::string name,
                  const Transform<World, Object>& world_from_object) {
  Node node;
  node.name = std::move(name);
  node.parent_from_node = world_from_object;
  node.world_from_node = world_from_object;
  scene.instances.push_back({mesh, std::uint32_t(scene.nodes.size())});
  scene.nodes.push_back(std::move(node));
}

std::uint32_t add_material(Scene& scene, std::string name, const Rgba& color) {
  Material material;
  material.name = std::move(name);
  material.base_color = color;
  scene.materials.push_back(std::move(material));
  return std::uint32_t(scene.materials.size() - 1);
}

std::uint32_t add_texture(Scene& scene, Image<Rgba8> image) {
  scene.textures.push_back({std::uint32_t(scene.images.size()), Sampler{}});
  scene.images.push_back(std::move(image));
  return std::uint32_t(scene.textures.size() - 1);
}

void add_perspective(Scene& scene, std::string name, double fovy_degrees, double near,
                     const Transform<World, Eye>& world_from_eye) {
  PerspectiveLens lens;
  lens.fovy_radians = radians_from_degrees(fovy_degrees);
  lens.near = near;
  scene.cameras.push_back({std::move(name), lens, world_from_eye});
}

void add_directional(Scene& scene, std::string name, const Vector<World, double>& direction,
                     double lux, const std::array<float, 3>& color) {
  Light light;
  light.name = std::move(name);
  light.kind = LightKind::kDirectional;
  light.color = color;
  light.intensity = lux;
  light.direction = unit(direction);
  scene.lights.push_back(std::move(light));
}

}  // namespace glassbox
