#include <glassbox/mesh/obj/build.h>

#include <cmath>

#include <glassbox/base/counted.h>
#include <glassbox/images/srgb.h>

namespace glassbox::obj {
namespace {

// Maps the entries of one table of the file to entries of the current mesh. Nothing has to be
// cleared when the next mesh starts.
class Renumbering {
public:
  explicit Renumbering(std::size_t size) : mesh_of_(size, kNone), local_(size, kNone) {}

  // True if `mesh` has used the entry before; local() then returns the entry's number in the mesh.
  bool knows(std::uint32_t global, std::uint32_t mesh) const { return mesh_of_[global] == mesh; }
  std::uint32_t local(std::uint32_t global) const { return local_[global]; }
  void set(std::uint32_t global, std::uint32_t mesh, std::uint32_t local) {
    mesh_of_[global] = mesh;
    local_[global] = local;
  }
  bool never_used(std::uint32_t global) const { return mesh_of_[global] == kNone; }

private:
  std::vector<std::uint32_t> mesh_of_, local_;
};

// The normal scaled to unit length, computed in double; absent for the zero vector, which has no
// direction.
std::optional<Normal<Object>> normalized(const Normal<Object>& n) {
  const double x = n.x, y = n.y, z = n.z;
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return std::nullopt;
  return Normal<Object>(float(x / length), float(y / length), float(z / length));
}

// The texture coordinates with the material's map applied and v reversed; absent if they are
// outside the range of float.
std::optional<TexCoord> placed(const TexCoord& t, const TexCoordMap& map) {
  const double u = double(map.scale[0]) * double(t.u) + double(map.offset[0]);
  const double v = double(map.scale[1]) * double(t.v) + double(map.offset[1]);
  const TexCoord moved{float(u), float(1.0 - v)};
  if (!std::isfinite(moved.u) || !std::isfinite(moved.v)) return std::nullopt;
  return moved;
}

// "object", "group" or "object/group". The length of names is limited here, because one long name
// can be part of very many meshes.
std::string mesh_name(const std::string& object, const std::string& group) {
  constexpr std::size_t kMaxLength = 255;
  std::string name = object.substr(0, kMaxLength);
  if (!name.empty() && !group.empty()) name += '/';
  return name + group.substr(0, kMaxLength);
}

class Builder {
public:
  explicit Builder(const Tables& tables)
      : tables_(tables),
        positions_(tables.positions.size()),
        colors_(tables.colors.size()),
        texcoords_(tables.texcoords.size()),
        normals_(tables.normals.size()) {}

  void start(std::uint32_t number, Mesh& mesh, const TexCoordMap& map) {
    number_ = number;
    mesh_ = &mesh;
    texcoord_map_ = map;
  }

  void add(const Element& element) {
    const Reference* const first = &tables_.references[element.first];
    switch (element.kind) {
      case ElementKind::kFace:
        mesh_->faces.push_back({std::uint32_t(mesh_->corners.size()), element.count});
        for (std::uint32_t i = 0; i < element.count; ++i) {
          mesh_->corners.push_back(corner(first[i]));
        }
        break;
      case ElementKind::kPolyline:
        for (std::uint32_t i = 0; i + 1 < element.count; ++i) {
          mesh_->lines.push_back({corner(first[i]), corner(first[i + 1])});
        }
        break;
      case ElementKind::kPoints:
        for (std::uint32_t i = 0; i < element.count; ++i) {
          mesh_->points.push_back(corner(first[i]));
        }
        break;
    }
  }

  std::uint64_t unused_positions() const {
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < tables_.positions.size(); ++i) count += positions_.never_used(i);
    return count;
  }
  std::uint64_t lost_texcoords() const { return lost_texcoords_; }

private:
  Corner corner(const Reference& r) {
    return {position(r.position), normal(r.normal), texcoord(r.texcoord), color(r.position)};
  }

  std::uint32_t position(std::uint32_t global) {
    if (!positions_.knows(global, number_)) {
      positions_.set(global, number_, std::uint32_t(mesh_->positions.size()));
      mesh_->positions.push_back(tables_.positions[global]);
    }
    return positions_.local(global);
  }

  // A colour belongs to a vertex of the file, so it is found by the vertex's index.
  std::uint32_t color(std::uint32_t vertex) {
    if (tables_.colors.empty() || !tables_.colors[vertex].given) return kNone;
    if (!colors_.knows(vertex, number_)) {
      colors_.set(vertex, number_, std::uint32_t(mesh_->colors.size()));
      const VertexColor& c = tables_.colors[vertex];
      mesh_->colors.push_back(Rgba{decode_srgb(c.r), decode_srgb(c.g), decode_srgb(c.b), 1.0f});
    }
    return colors_.local(vertex);
  }

  std::uint32_t texcoord(std::uint32_t global) {
    if (global == kNone) return kNone;
    if (!texcoords_.knows(global, number_)) {
      const TexCoord& written = tables_.texcoords[global];
      const auto t = placed(written, texcoord_map_);
      if (!t && std::isfinite(written.u)) ++lost_texcoords_;
      texcoords_.set(global, number_, t ? std::uint32_t(mesh_->texcoords.size()) : kNone);
      if (t) mesh_->texcoords.push_back(*t);
    }
    return texcoords_.local(global);
  }

  std::uint32_t normal(std::uint32_t global) {
    if (global == kNone) return kNone;
    if (!normals_.knows(global, number_)) {
      const auto n = normalized(tables_.normals[global]);
      normals_.set(global, number_, n ? std::uint32_t(mesh_->normals.size()) : kNone);
      if (n) mesh_->normals.push_back(*n);
    }
    return normals_.local(global);
  }

  const Tables& tables_;
  Renumbering positions_, colors_, texcoords_, normals_;
  std::uint64_t lost_texcoords_ = 0;

  std::uint32_t number_ = 0;
  Mesh* mesh_ = nullptr;
  TexCoordMap texcoord_map_;
};

// The elements grouped by part, in the order of the file: a counting sort.
struct ElementsByPart {
  std::vector<std::uint32_t> begin;  // where part i begins in `elements`; one more entry than parts
  std::vector<std::uint32_t> elements;  // indices into Tables::elements

  explicit ElementsByPart(const Tables& tables)
      : begin(tables.parts.size() + 1), elements(tables.elements.size()) {
    for (const Element& element : tables.elements) ++begin[element.part + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < tables.elements.size(); ++i) {
      elements[next[tables.elements[i].part]++] = i;
    }
  }
};

}  // namespace

void build_meshes(const Tables& tables, MaterialMaker& materials, Scene& scene,
                  Warnings& warnings) {
  scene.nodes.emplace_back();
  scene.meshes.reserve(tables.parts.size());
  scene.instances.reserve(tables.parts.size());
  const ElementsByPart by_part(tables);
  std::map<std::uint32_t, MaterialMaker::Made> made;  // by the number of the material's name
  Builder builder(tables);
  for (std::uint32_t number = 0; number < tables.parts.size(); ++number) {
    const Part& part = tables.parts[number];
    const auto [material, is_first] = made.try_emplace(part.material);
    if (is_first) material->second = materials.make(tables.names[part.material]);
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = mesh_name(tables.names[part.object], tables.names[part.group]);
    mesh.material = material->second.index;
    builder.start(number, mesh, material->second.texcoord_map);
    for (std::uint32_t i = by_part.begin[number]; i < by_part.begin[number + 1]; ++i) {
      builder.add(tables.elements[by_part.elements[i]]);
    }
    scene.instances.push_back({number, 0});
  }
  if (const std::uint64_t unused = builder.unused_positions(); unused > 0) {
    warnings.add(
        std::to_string(unused) + " of " + std::to_string(tables.positions.size()) + " vertices " +
        singular_or_plural(unused, "is not used and was", "are not used and were") + " left out");
  }
  if (builder.lost_texcoords() > 0) {
    warnings.add(counted(builder.lost_texcoords(),
                         "pair of texture coordinates is too large for floats and was",
                         "pairs of texture coordinates are too large for floats and were") +
                 " left out");
  }
}

}  // namespace glassbox::obj
