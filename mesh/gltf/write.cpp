#include <glassbox/mesh/gltf/write.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/gltf/describe.h>
#include <glassbox/mesh/gltf/glb_bytes.h>
#include <glassbox/mesh/gltf/text.h>
#include <glassbox/mesh/gltf/unified_mesh.h>

namespace glassbox {
namespace {

using gltf::BinaryChunk;
using gltf::check_finite;
using gltf::entry;
using gltf::UnifiedPrimitive;
using nlohmann::json;

// glTF's codes for types.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertexData = 34962;
constexpr int kIndexData = 34963;

// ---- the document ----

class Writer {
public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  Result<std::vector<std::byte>> encode() {
    document_["asset"] = {{"version", "2.0"}, {"generator", "Glassbox"}};
    if (auto done = write_images(); !done) return tl::unexpected(done.error());
    write_textures();
    for (const Material& material : scene_.materials) {
      document_["materials"].push_back(gltf::describe(material));
      const json& described = document_["materials"].back();
      if (described.contains("extensions")) {
        for (const auto& [name, extension] : described["extensions"].items()) use(name.c_str());
      }
    }
    if (auto done = write_meshes(); !done) return tl::unexpected(done.error());
    write_nodes();
    if (auto done = write_cameras(); !done) return tl::unexpected(done.error());
    write_lights();
    json scene{{"nodes", roots_}};
    if (!scene_.name.empty()) scene["name"] = scene_.name;
    document_["scene"] = 0;
    document_["scenes"].push_back(scene);
    if (!used_.empty()) document_["extensionsUsed"] = used_;
    if (binary_.size() > 0) document_["buffers"].push_back({{"byteLength", binary_.size()}});
    return assemble_glb(document_, binary_);
  }

private:
  // -- pictures --

  Result<void> write_images() {
    for (std::size_t i = 0; i < scene_.images.size(); ++i) {
      const auto png = encode_png(scene_.images[i]);
      if (!png) return fail(entry("image", i), png.error().cause, png.error().remedy);
      const std::size_t offset = binary_.size();
      binary_.append(*png);
      document_["images"].push_back(
          {{"mimeType", "image/png"}, {"bufferView", add_view(offset, png->size(), std::nullopt)}});
    }
    return {};
  }

  void write_textures() {
    for (const Texture& texture : scene_.textures) {
      document_["textures"].push_back(
          {{"sampler", document_["samplers"].size()}, {"source", texture.image}});
      document_["samplers"].push_back(gltf::describe(texture.sampler));
    }
  }

  // -- meshes --

  std::size_t add_view(std::size_t offset, std::size_t size, std::optional<int> target) {
    json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
    if (target) view["target"] = *target;
    document_["bufferViews"].push_back(view);
    return document_["bufferViews"].size() - 1;
  }

  // Makes one accessor of the binary data from `offset` on, and returns its index.
  std::size_t add_accessor(std::size_t offset, int component_type, const char* type,
                           std::size_t count, int target) {
    const std::size_t view = add_view(offset, binary_.size() - offset, target);
    document_["accessors"].push_back({{"bufferView", view},
                                      {"componentType", component_type},
                                      {"count", count},
                                      {"type", type}});
    return document_["accessors"].size() - 1;
  }

  // Writes the numbers that `numbers` returns for each vertex, one after the other.
  template <class Numbers>
  std::size_t write_attribute(const UnifiedPrimitive& primitive, const char* type,
                              Numbers numbers) {
    const std::size_t offset = binary_.size();
    for (const Corner& vertex : primitive.vertices) {
      for (const float number : numbers(vertex)) binary_.append(number);
    }
    return add_accessor(offset, kFloat, type, primitive.vertices.size(), kVertexData);
  }

  std::size_t write_positions(const Mesh& mesh, const UnifiedPrimitive& primitive) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    std::array<float, 3> low{kInfinity, kInfinity, kInfinity},
        high{-kInfinity, -kInfinity, -kInfinity};
    const std::size_t index = write_attribute(primitive, "VEC3", [&](const Corner& vertex) {
      const Point<Object>& p = mesh.positions[vertex.position];
      const std::array numbers{p.x, p.y, p.z};
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], numbers[i]);
        high[i] = std::max(high[i], numbers[i]);
      }
      return numbers;
    });
    document_["accessors"][index]["min"] = low;
    document_["accessors"][index]["max"] = high;
    return index;
  }

  std::size_t write_normals(const Mesh& mesh, const UnifiedPrimitive& primitive) {
    return write_attribute(primitive, "VEC3", [&](const Corner& vertex) {
      const Normal<Object>& n = mesh.normals[vertex.normal];
      return std::array{n.x, n.y, n.z};
    });
  }

  std::size_t write_texcoords(const Mesh& mesh, const UnifiedPrimitive& primitive) {
    return write_attribute(primitive, "VEC2", [&](const Corner& vertex) {
      const TexCoord t = vertex.texcoord == kNone ? TexCoord{} : mesh.texcoords[vertex.texcoord];
      return std::array{t.u, t.v};
    });
  }

  std::size_t write_colors(const Mesh& mesh, const UnifiedPrimitive& primitive) {
    return write_attribute(primitive, "VEC4", [&](const Corner& vertex) {
      const Rgba c = vertex.color == kNone ? Rgba{} : mesh.colors[vertex.color];
      return std::array{c.r, c.g, c.b, c.a};
    });
  }

  json describe(const Mesh& mesh, const UnifiedPrimitive& primitive) {
    json attributes{{"POSITION", write_positions(mesh, primitive)}};
    if (primitive.has_normals) attributes["NORMAL"] = write_normals(mesh, primitive);
    if (primitive.has_texcoords) attributes["TEXCOORD_0"] = write_texcoords(mesh, primitive);
    if (primitive.has_colors) attributes["COLOR_0"] = write_colors(mesh, primitive);
    const std::size_t offset = binary_.size();
    for (const std::uint32_t index : primitive.indices) binary_.append(index);
    const std::size_t indices =
        add_accessor(offset, kUnsignedInt, "SCALAR", primitive.indices.size(), kIndexData);
    return {{"attributes", attributes},
            {"indices", indices},
            {"material", mesh.material},
            {"mode", primitive.mode}};
  }

  Result<void> write_meshes() {
    for (const Mesh& mesh : scene_.meshes) {
      const auto primitives = gltf::unify(mesh);
      if (!primitives) return tl::unexpected(primitives.error());
      mesh_numbers_.push_back(std::nullopt);
      if (primitives->empty()) continue;  // glTF has no empty meshes
      json described;
      if (!mesh.name.empty()) described["name"] = mesh.name;
      for (const UnifiedPrimitive& primitive : *primitives)
        described["primitives"].push_back(describe(mesh, primitive));
      mesh_numbers_.back() = document_["meshes"].size();
      document_["meshes"].push_back(described);
    }
    if (!document_.contains("meshes")) {
      return fail("", "the scene has nothing to draw: no triangle has an area",
                  "add a mesh before writing the scene");
    }
    return {};
  }

  // -- nodes --

  static json numbers(const glm::dmat4& columns) {
    json list = json::array();
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) list.push_back(columns[column][row]);
    }
    return list;
  }

  std::size_t add_node(const std::string& name) {
    json node = json::object();
    if (!name.empty()) node["name"] = name;
    document_["nodes"].push_back(node);
    return document_["nodes"].size() - 1;
  }

  json& node(std::size_t index) { return document_["nodes"][index]; }

  std::size_t add_root(const std::string& name, const glm::dmat4& columns) {
    const std::size_t index = add_node(name);
    node(index)["matrix"] = numbers(columns);
    roots_.push_back(index);
    return index;
  }

  // The indices of the instances at each node.
  std::vector<std::vector<std::size_t>> instances_by_node() const {
    std::vector<std::vector<std::size_t>> by_node(scene_.nodes.size());
    for (std::size_t i = 0; i < scene_.instances.size(); ++i)
      by_node[scene_.instances[i].node].push_back(i);
    return by_node;
  }

  std::vector<std::vector<std::size_t>> children_by_node() const {
    std::vector<std::vector<std::size_t>> by_node(scene_.nodes.size());
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (scene_.nodes[i].parent != kNone) by_node[scene_.nodes[i].parent].push_back(i);
    }
    return by_node;
  }

  // Whether a depth-first walk over the hierarchy, parents first, visits the instances in the order
  // in which they are drawn.
  bool order_follows_hierarchy() const {
    const auto instances = instances_by_node();
    const auto children = children_by_node();
    std::vector<std::size_t> stack;
    for (std::size_t i = scene_.nodes.size(); i-- > 0;) {
      if (scene_.nodes[i].parent == kNone) stack.push_back(i);
    }
    std::size_t next = 0;
    while (!stack.empty()) {
      const std::size_t at = stack.back();
      stack.pop_back();
      for (const std::size_t instance : instances[at]) {
        if (instance != next++) return false;
      }
      stack.insert(stack.end(), children[at].rbegin(), children[at].rend());
    }
    return true;
  }

  void write_nodes() {
    if (order_follows_hierarchy()) {
      write_hierarchy();
    } else {
      write_flat();
    }
  }

  // Writes the nodes with their hierarchy. A glTF node has at most one mesh, so a node with several
  // instances gets a child for each instance, before its other children.
  void write_hierarchy() {
    for (const Node& described : scene_.nodes) {
      const std::size_t index = add_node(described.name);
      if (described.parent_from_node != Transform<World, Object>()) {
        node(index)["matrix"] = numbers(described.parent_from_node.columns);
      }
    }
    const auto instances = instances_by_node();
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (instances[i].size() == 1) {
        set_mesh(i, instances[i][0]);
        continue;
      }
      for (const std::size_t instance : instances[i]) {
        const std::size_t child = add_node("");
        set_mesh(child, instance);
        node(i)["children"].push_back(child);
      }
    }
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (scene_.nodes[i].parent == kNone) {
        roots_.push_back(i);
      } else {
        node(scene_.nodes[i].parent)["children"].push_back(i);
      }
    }
  }

  // Writes every instance as a root node of its own: the hierarchy is lost, but the picture is the
  // same.
  void write_flat() {
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      const Node& described = scene_.nodes[scene_.instances[i].node];
      set_mesh(add_root(described.name, described.world_from_node.columns), i);
    }
  }

  void set_mesh(std::size_t at, std::size_t instance) {
    const auto& number = mesh_numbers_[scene_.instances[instance].mesh];
    if (number) node(at)["mesh"] = *number;
  }

  // -- cameras and lights: each becomes a root node of its own --

  Result<void> write_cameras() {
    for (std::size_t i = 0; i < scene_.cameras.size(); ++i) {
      const Camera& camera = scene_.cameras[i];
      if (!camera.fault.empty()) continue;
      auto described = gltf::describe(camera);
      if (!described) {
        return fail(entry("camera", i) + " " + in_quotes(camera.name), described.error().cause,
                    described.error().remedy);
      }
      const std::size_t number = document_["cameras"].size();
      node(add_root(camera.name, camera.world_from_eye.columns))["camera"] = number;
      document_["cameras"].push_back(std::move(*described));
    }
    return {};
  }

  void write_lights() {
    if (scene_.lights.empty()) return;
    use("KHR_lights_punctual");
    json& list = document_["extensions"]["KHR_lights_punctual"]["lights"];
    for (const Light& light : scene_.lights) {
      const std::size_t at = add_root(light.name, gltf::pose_of(light));
      node(at)["extensions"]["KHR_lights_punctual"]["light"] = list.size();
      list.push_back(gltf::describe(light));
    }
  }

  void use(const char* extension) {
    if (std::ranges::find(used_, extension) == used_.end()) used_.push_back(extension);
  }

  const Scene& scene_;
  json document_;
  BinaryChunk binary_;
  // For each of Scene::meshes its index in the file; none if the mesh draws nothing.
  std::vector<std::optional<std::size_t>> mesh_numbers_;
  std::vector<std::size_t> roots_;
  std::vector<std::string> used_;
};

}  // namespace

Result<std::vector<std::byte>> encode_glb(const Scene& scene) {
  if (auto finite = check_finite(scene); !finite) return tl::unexpected(finite.error());
  return Writer(scene).encode();
}

Result<void> write_glb(const Scene& scene, const std::string& path) {
  const auto bytes = encode_glb(scene);
  if (!bytes) {
    Error error = bytes.error();
    error.file = path;
    return tl::unexpected(std::move(error));
  }
  return write_file(path, *bytes);
}

}  // namespace glassbox
