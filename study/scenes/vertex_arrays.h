// A mesh as OpenGL draws it: one index a corner, attributes side by side.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/mesh/mesh.h>
#include <glassbox/render/engine/prepared_scene.h>

namespace glassbox::study {

// Of each vertex: position (3 floats), then normal (3), texture coordinates (2) and colour (4), those that the mesh has.
struct VertexArrays {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle, in the order of the triangulation
  bool normals = false, texcoords = false, colors = false;

  std::size_t floats_per_vertex() const {
    return 3u + (normals ? 3u : 0u) + (texcoords ? 2u : 0u) + (colors ? 4u : 0u);
  }
  std::size_t vertex_count() const { return vertices.size() / floats_per_vertex(); }
  std::size_t bytes() const {
    return vertices.size() * sizeof(float) + indices.size() * sizeof(std::uint32_t);
  }
};

// The triangles that the engines draw. A mesh whose corners have one index into all its tables keeps the order of its
// vertices; of any other, corners with the same entries become one vertex, in the order of their first use. Corners without a
// normal have their face's. Without `normals` there are none. Positions are relative to `anchor` (render/engine/draw_list.h).
VertexArrays vertex_arrays(const Mesh& mesh, const PreparedMesh& prepared, bool normals,
                           const Vector<Object>& anchor = {});

}  // namespace glassbox::study
