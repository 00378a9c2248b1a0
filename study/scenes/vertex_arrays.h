// A mesh as OpenGL draws it: one index a corner, attributes side by side.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/mesh/mesh.h>

namespace glassbox::study {

// Of each vertex: position (3 floats), then normal (3), texture coordinates (2) and colour (3), those that the mesh has.
struct VertexArrays {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle, in the order of the faces
  bool normals = false, texcoords = false, colors = false;

  std::size_t floats_per_vertex() const {
    return 3u + (normals ? 3u : 0u) + (texcoords ? 2u : 0u) + (colors ? 3u : 0u);
  }
  std::size_t bytes() const {
    return vertices.size() * sizeof(float) + indices.size() * sizeof(std::uint32_t);
  }
};

// The mesh is made of triangles, and each of its corners has one index into all the tables that there are, as those of
// the benchmark's scenes do.
VertexArrays vertex_arrays(const Mesh& mesh);

}  // namespace glassbox::study
