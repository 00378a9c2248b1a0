// The node hierarchy: who stands below whom, and where everything stands in the world.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

struct NodeTree {
  std::vector<Transform<World, Object>> world_from_node;  // of every node in the file
  // The nodes of the scene that is drawn, parents before children and in the file's order: index into the file, and
  // into Scene::nodes (kNone for nodes of other scenes).
  std::vector<std::uint32_t> drawn;
  std::vector<std::uint32_t> scene_index;
};

// What stands in the space of a node, in the world: the node takes the world's place for what is below it.
inline Transform<World, Object> compose(const Transform<World, Object>& world_from_node,
                                        const Transform<World, Object>& node_from_child) {
  return Transform<World, World>(world_from_node.columns) * node_from_child;
}

// Checks the hierarchy as a whole (one parent each, no cycles, bounded depth, finite matrices) and puts the nodes of the
// default scene into scene.nodes.
Result<NodeTree> place_nodes(const Asset& asset, Scene& scene);

}  // namespace glassbox::gltf
