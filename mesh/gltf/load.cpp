#include <glassbox/mesh/gltf/load.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include <glassbox/mesh/gltf/accessors.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/cameras_lights.h>
#include <glassbox/mesh/gltf/materials.h>
#include <glassbox/mesh/gltf/missing_features.h>
#include <glassbox/mesh/gltf/nodes.h>
#include <glassbox/mesh/gltf/primitive.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox {
namespace {

using namespace gltf;

// Makes the meshes that the nodes draw. A primitive becomes one Mesh, shared by all nodes that draw
// it in the same pose.
class MeshTable {
public:
  MeshTable(Asset& asset, const NodeTree& tree, const Materials& materials, Scene& scene)
      : asset_(asset),
        tree_(tree),
        materials_(materials),
        scene_(scene),
        joints_(asset.model.skins.size()),
        building_(
            std::min(asset.limits.max_corners, kFreeElements + kElementsPerByte * asset.bytes)),
        instances_(kFreeInstances + asset.bytes),
        instancing_(asset.limits.max_corners) {}

  Result<void> add_instances(std::uint32_t node) {
    const tinygltf::Node& described = asset_.model.nodes[node];
    const std::size_t mesh = std::size_t(described.mesh);
    const bool skinned = described.skin >= 0;
    for (std::size_t i = 0; i < asset_.model.meshes[mesh].primitives.size(); ++i) {
      if (!instances_.take(1)) {
        return fail(entry("node", node),
                    "all nodes together draw more than " + std::to_string(instances_.size()) +
                        " primitives, the most for a file of " + std::to_string(asset_.bytes) +
                        " bytes",
                    "join the primitives of each mesh into one");
      }
      const auto index = add_mesh(node, {mesh, i});
      if (!index) return tl::unexpected(index.error());
      if (!*index) continue;
      const Mesh& made = scene_.meshes[**index];
      if (!instancing_.take(made.corners.size() + 2 * made.lines.size() + made.points.size())) {
        return fail(entry("node", node),
                    "the meshes of all nodes together have more than " +
                        std::to_string(asset_.limits.max_corners) +
                        " corners, the most that are read",
                    "draw fewer or smaller meshes (in the library: LoadLimits::max_corners)");
      }
      // A skinned mesh is placed by its joints; its node's transform is ignored (glTF 2.0, section
      // 3.7.3.3).
      scene_.instances.push_back({**index, skinned ? identity_node() : tree_.scene_index[node]});
    }
    return {};
  }

private:
  // Within the limits of the caller, a scene may have kFreeElements, and kElementsPerByte more for
  // each byte of the file. Legal files share data: a hundred spheres with the same accessors make
  // ten corners from each byte. An element of a mesh takes up to 48 bytes of memory, an instance
  // eight.
  static constexpr std::uint64_t kFreeElements = std::uint64_t(1) << 22;
  static constexpr std::uint64_t kElementsPerByte = 16;
  static constexpr std::uint64_t kFreeInstances = std::uint64_t(1) << 20;

  // What determines a mesh: the mesh and the primitive in the file, the skin (-1 if none), and the
  // weights of morph targets if the node has its own.
  using Key = std::tuple<std::size_t, std::size_t, int, std::vector<double>>;

  Result<std::vector<double>> weights_of(std::uint32_t node, PrimitiveId id) const {
    const tinygltf::Node& described = asset_.model.nodes[node];
    const tinygltf::Mesh& mesh = asset_.model.meshes[id.mesh];
    const std::vector<double>& weights =
        described.weights.empty() ? mesh.weights : described.weights;
    const std::size_t targets = mesh.primitives[id.primitive].targets.size();
    if (!weights.empty() && weights.size() != targets) {
      return fail(entry("mesh", id.mesh) + ", " + entry("primitive", id.primitive),
                  "has " + std::to_string(targets) + " morph targets but " +
                      std::to_string(weights.size()) + " weights",
                  "export the morph targets again");
    }
    return weights;
  }

  Result<const JointMatrices*> joints_of(int skin) {
    if (skin < 0) return nullptr;
    std::optional<JointMatrices>& joints = joints_[std::size_t(skin)];
    if (!joints) {
      auto made = joint_matrices(asset_, tree_, std::size_t(skin));
      if (!made) return tl::unexpected(made.error());
      joints = std::move(*made);
    }
    return &*joints;
  }

  Result<std::optional<std::uint32_t>> add_mesh(std::uint32_t node, PrimitiveId id) {
    auto weights = weights_of(node, id);
    if (!weights) return tl::unexpected(weights.error());
    const int skin = asset_.model.nodes[node].skin;
    const Key key{id.mesh, id.primitive, skin, asset_.model.nodes[node].weights};
    if (const auto known = known_.find(key); known != known_.end()) return known->second;

    const auto joints = joints_of(skin);
    if (!joints) return tl::unexpected(joints.error());
    const int named = asset_.model.meshes[id.mesh].primitives[id.primitive].material;
    const std::size_t material = named < 0 ? scene_.materials.size() - 1 : std::size_t(named);
    auto mesh = convert_primitive(asset_, id, {std::move(*weights), *joints},
                                  materials_.texcoords[material], building_);
    if (!mesh) return tl::unexpected(mesh.error());
    if (!*mesh) return known_[key] = std::nullopt;
    (*mesh)->material = std::uint32_t(material);
    scene_.meshes.push_back(std::move(**mesh));
    return known_[key] = std::uint32_t(scene_.meshes.size() - 1);
  }

  std::uint32_t identity_node() {
    if (!identity_) {
      identity_ = std::uint32_t(scene_.nodes.size());
      scene_.nodes.push_back({"skinned meshes", kNone, {}, {}});
    }
    return *identity_;
  }

  Asset& asset_;
  const NodeTree& tree_;
  const Materials& materials_;
  Scene& scene_;
  std::vector<std::optional<JointMatrices>> joints_;  // by the index of the skin
  std::map<Key, std::optional<std::uint32_t>> known_;
  std::optional<std::uint32_t> identity_;
  Budget building_;
  Budget instances_;
  Budget instancing_;
};

Result<Scene> build_scene(Asset& asset) {
  if (auto done = check_accessors(asset); !done) return tl::unexpected(done.error());
  Scene scene;
  const auto tree = place_nodes(asset, scene);
  if (!tree) return tl::unexpected(tree.error());
  const auto materials = convert_materials(asset, *tree, scene);
  if (!materials) return tl::unexpected(materials.error());
  MeshTable meshes(asset, *tree, *materials, scene);
  for (const std::uint32_t node : tree->drawn) {
    if (asset.model.nodes[node].mesh < 0) continue;
    if (auto done = meshes.add_instances(node); !done) return tl::unexpected(done.error());
  }
  if (scene.instances.empty()) {
    const std::vector<std::string> warnings = asset.all_warnings();
    const auto left_out = std::ranges::find_if(
        warnings, [](const std::string& w) { return w.ends_with("not drawn"); });
    const std::string why = left_out == warnings.end() ? std::string() : " (" + *left_out + ")";
    return fail("", "the scene has nothing to draw" + why,
                "choose a file with a mesh in its default scene");
  }
  if (auto done = place_cameras_and_lights(asset, *tree, scene); !done)
    return tl::unexpected(done.error());
  scene.extensions = asset.extensions;
  warn_about_missing_features(asset, *tree, *materials, scene);
  scene.warnings = asset.all_warnings();
  return scene;
}

}  // namespace

Result<Scene> load_gltf_memory(std::span<const std::byte> bytes, const std::string& directory,
                               const LoadLimits& limits) {
  return naming_file("", [&]() -> Result<Scene> {
    auto asset = open_asset(bytes, directory, limits);
    if (!asset) return tl::unexpected(asset.error());
    return build_scene(*asset);
  });
}

Result<Scene> load_gltf(const std::string& path, const LoadLimits& limits) {
  return naming_file(path, [&]() -> Result<Scene> {
    auto asset = open_asset(path, limits);
    if (!asset) return tl::unexpected(asset.error());
    auto scene = build_scene(*asset);
    if (scene) scene->file = path;
    return scene;
  });
}

}  // namespace glassbox
