#include "study/scenes/vertex_arrays.h"

namespace glassbox::study {

VertexArrays vertex_arrays(const Mesh& mesh) {
  VertexArrays arrays;
  arrays.normals = !mesh.normals.empty();
  arrays.texcoords = !mesh.texcoords.empty();
  arrays.colors = !mesh.colors.empty();
  arrays.vertices.reserve(mesh.positions.size() * arrays.floats_per_vertex());
  const auto append = [&](auto... values) { (arrays.vertices.push_back(values), ...); };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point<Object>& p = mesh.positions[i];
    append(p.x, p.y, p.z);
    if (arrays.normals) append(mesh.normals[i].x, mesh.normals[i].y, mesh.normals[i].z);
    if (arrays.texcoords) append(mesh.texcoords[i].u, mesh.texcoords[i].v);
    if (arrays.colors) append(mesh.colors[i].r, mesh.colors[i].g, mesh.colors[i].b);
  }
  arrays.indices.reserve(mesh.corners.size());
  for (const Face& face : mesh.faces) {
    for (std::uint32_t i = 0; i < face.count; ++i) {
      arrays.indices.push_back(mesh.corners[face.first + i].position);
    }
  }
  return arrays;
}

}  // namespace glassbox::study
