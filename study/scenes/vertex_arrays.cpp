#include "study/scenes/vertex_arrays.h"

#include <array>
#include <map>

#include <glassbox/mesh/normals.h>

namespace glassbox::study {

namespace {

// The indices of a vertex into the mesh's tables; kNone where the vertex lacks the attribute.
struct Vertex {
  std::uint32_t position = kNone, normal = kNone, texcoord = kNone, color = kNone;
  friend auto operator<=>(const Vertex&, const Vertex&) = default;
};

// Returns the index of a corner's attribute. If the attribute has no index list of its own, the
// indices of the positions are used.
std::uint32_t entry(const std::vector<std::uint32_t>& indices, const CornerIndices& all,
                    std::size_t corner) {
  return indices.empty() ? all.positions[corner] : indices[corner];
}

class Writer {
public:
  Writer(const Mesh& mesh, const PreparedMesh& prepared, bool normals, const Vector<Object>& anchor)
      : mesh_(mesh), indices_(prepared.indices), anchor_(anchor) {
    arrays_.normals = normals;
    arrays_.texcoords = indices_.has_texcoords;
    arrays_.colors = indices_.has_colors;
  }

  VertexArrays write() {
    if (has_one_index()) {
      write_tables();
    } else {
      write_corners();
    }
    return std::move(arrays_);
  }

private:
  bool has_one_index() const {
    return (!arrays_.normals || indices_.normals.empty()) && indices_.texcoords.empty() &&
           indices_.colors.empty();
  }

  void write_tables() {
    arrays_.vertices.reserve(mesh_.positions.size() * arrays_.floats_per_vertex());
    for (std::uint32_t i = 0; i < mesh_.positions.size(); ++i) append({i, i, i, i});
    arrays_.indices = indices_.positions;
  }

  void write_corners() {
    std::map<Vertex, std::uint32_t> known;
    for (std::size_t i = 0; i < indices_.positions.size(); ++i) {
      Vertex vertex{indices_.positions[i], kNone, kNone, kNone};
      if (arrays_.normals) vertex.normal = entry(indices_.normals, indices_, i);
      if (arrays_.texcoords) vertex.texcoord = entry(indices_.texcoords, indices_, i);
      if (arrays_.colors) vertex.color = entry(indices_.colors, indices_, i);
      const auto [at, is_first] = known.try_emplace(vertex, std::uint32_t(known.size()));
      if (is_first) append(vertex);
      arrays_.indices.push_back(at->second);
    }
  }

  void append(const Vertex& vertex) {
    const Point<Object>& p = mesh_.positions[vertex.position];
    append_floats(p.x - anchor_.x, p.y - anchor_.y, p.z - anchor_.z);
    if (arrays_.normals) append_normal(vertex.normal);
    if (arrays_.texcoords) {
      const bool has_one = vertex.texcoord < mesh_.texcoords.size();
      const TexCoord t = has_one ? mesh_.texcoords[vertex.texcoord] : TexCoord{};
      append_floats(t.u, t.v);
    }
    if (arrays_.colors) {
      const bool has_one = vertex.color < mesh_.colors.size();
      const Rgba c = has_one ? mesh_.colors[vertex.color] : Rgba{};
      append_floats(c.r, c.g, c.b, c.a);
    }
  }

  // Appends a normal. An index beyond the end of the table of normals stands for the normal of a
  // face, whose number is the index minus the table's size.
  void append_normal(std::uint32_t index) {
    Normal<Object> normal{};
    if (index < mesh_.normals.size()) {
      normal = mesh_.normals[index];
    } else if (const std::size_t face = index - mesh_.normals.size(); face < mesh_.faces.size()) {
      normal = face_normal(mesh_, mesh_.faces[face]).value_or(normal);
    }
    append_floats(normal.x, normal.y, normal.z);
  }

  void append_floats(auto... values) { (arrays_.vertices.push_back(values), ...); }

  const Mesh& mesh_;
  const CornerIndices& indices_;
  const Vector<Object>& anchor_;
  VertexArrays arrays_;
};

}  // namespace

VertexArrays vertex_arrays(const Mesh& mesh, const PreparedMesh& prepared, bool normals,
                           const Vector<Object>& anchor) {
  return Writer(mesh, prepared, normals, anchor).write();
}

}  // namespace glassbox::study
