// The node hierarchy: the parent of each node, and its transform to world space.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

struct NodeTree {
  std::vector<Transform<World, Object>> world_from_node;  // of every node in the file
  // The nodes of the scene that is drawn, parents before children and in the file's order: `drawn`
  // has indices into the file, `scene_index` indices into Scene::nodes (kNone for nodes of other
  // scenes).
  std::vector<std::uint32_t> drawn;
  std::vector<std::uint32_t> scene_index;
};

// Returns world_from_child. The type of `node_from_child` says World for the space of the node,
// because there is no type for that space.
inline Transform<World, Object> compose(const Transform<World, Object>& world_from_node,
                                        const Transform<World, Object>& node_from_child) {
  return Transform<World, World>(world_from_node.columns) * node_from_child;
}

// The matrix of a node that place_nodes() has accepted, as if it had no scale. A node that is given
// by a matrix keeps it: a matrix does not say which part of it is scale.
Transform<World, Object> without_scale(const tinygltf::Node& node);

// Checks the hierarchy (one parent each, no cycles, limited depth, finite matrices) and adds the
// nodes of the default scene to scene.nodes.
Result<NodeTree> place_nodes(const Asset& asset, Scene& scene);

}  // namespace glassbox::gltf
