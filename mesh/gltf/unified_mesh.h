// A Mesh in the form that glTF can store: runs of triangles, lines or points, each with one index
// per corner.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox::gltf {

// One glTF primitive. Each vertex is a distinct combination of indices into the tables of the mesh,
// in the order in which the corners first use it; `indices` refer to vertices.
struct UnifiedPrimitive {
  int mode = 4;  // glTF's numbers: 0 points, 1 lines, 4 triangles
  bool has_normals = false, has_texcoords = false, has_colors = false;
  std::vector<Corner> vertices;
  std::vector<std::uint32_t> indices;
};

// Divides the triangles, in the order of triangulate(), into runs whose corners have the same
// attributes; then come the lines, then the points. If only some corners of a run have a texture
// coordinate or a colour, the other corners get (0, 0) or white, with which they are drawn here,
// too. A triangle with normals on only some of its corners is an error: glTF cannot represent it.
Result<std::vector<UnifiedPrimitive>> unify(const Mesh& mesh);

}  // namespace glassbox::gltf
