// Bounding boxes of what is drawn.
#pragma once

#include <glassbox/base/box.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Calls `visit` with the position of every corner of the mesh's faces, lines and points. Positions
// that are not drawn are not visited.
template <class Visit>
void for_each_drawn_position(const Mesh& mesh, Visit visit) {
  for (const Corner& corner : mesh.corners) visit(mesh.positions[corner.position]);
  for (const auto& line : mesh.lines) {
    for (const Corner& corner : line) visit(mesh.positions[corner.position]);
  }
  for (const Corner& corner : mesh.points) visit(mesh.positions[corner.position]);
}

// The bounding box of what the mesh draws; empty if it draws nothing.
inline Box<Object> bounds(const Mesh& mesh) {
  Box<Object> box;
  for_each_drawn_position(mesh, [&](const Point<Object>& p) { box.include(p); });
  return box;
}

// Calls `visit` with the world position of every drawn corner of every instance of the scene.
template <class Visit>
void for_each_drawn_position(const Scene& scene, Visit visit) {
  for (const Instance& instance : scene.instances) {
    const Transform<World, Object>& world_from_object = scene.nodes[instance.node].world_from_node;
    for_each_drawn_position(scene.meshes[instance.mesh], [&](const Point<Object>& p) {
      visit(world_from_object * Point<Object, double>(p.x, p.y, p.z));
    });
  }
}

// The bounding box of all drawn positions in world space. Every position is transformed, because
// the box around the transformed corners of an object's own box could be larger.
inline Box<World> bounds(const Scene& scene) {
  Box<World> box;
  for_each_drawn_position(scene, [&](const Point<World, double>& p) { box.include(p); });
  return box;
}

}  // namespace glassbox
