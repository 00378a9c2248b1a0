// A mesh as OpenGL draws it: one index per corner, and interleaved attributes.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/mesh/mesh.h>
#include <glassbox/render/engine/prepared_scene.h>

namespace glassbox::study {

// Each vertex has a position (3 floats), then the attributes that the mesh has, in this order:
// normal (3 floats), texture coordinates (2) and colour (4).
struct VertexArrays {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle, in the order of the triangulation
  bool normals = false, texcoords = false, colors = false;

  std::size_t floats_per_vertex() const {
    return 3u + (normals ? 3u : 0u) + (texcoords ? 2u : 0u) + (colors ? 4u : 0u);
  }
  std::size_t vertex_count() const { return vertices.size() / floats_per_vertex(); }
  std::size_t bytes() const {
    return vertices.size() * sizeof(float) + indices.size() * sizeof(std::uint32_t);
  }
};

// Converts the triangles that the engines draw. If each corner of the mesh has one index into all
// tables, the vertices keep their order; otherwise corners with the same indices become one vertex,
// in the order of their first use. Corners without a normal get their face's normal. If `normals`
// is false, no normals are written. Positions are relative to `anchor` (render/engine/draw_list.h).
VertexArrays vertex_arrays(const Mesh& mesh, const PreparedMesh& prepared, bool normals,
                           const Vector<Object>& anchor = {});

}  // namespace glassbox::study
