#include <glassbox/mesh/gltf/nodes.h>

#include <cmath>
#include <string>

#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using Matrix = Transform<World, Object>;

constexpr const char* kCorrect = "correct the hierarchy or export the file again";

bool has_transform(const tinygltf::Node& node) {
  return !(node.matrix.empty() && node.translation.empty() && node.rotation.empty() &&
           node.scale.empty());
}

Result<Matrix> from_matrix(const std::vector<double>& numbers, std::size_t index) {
  Matrix matrix;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      matrix.at(row, column) = numbers[std::size_t(column * 4 + row)];
  }
  const auto is_unit = [](double a, double b, double c, double d) {
    return a == 0 && b == 0 && c == 0 && d == 1;
  };
  if (!is_unit(matrix.at(3, 0), matrix.at(3, 1), matrix.at(3, 2), matrix.at(3, 3))) {
    if (is_unit(matrix.at(0, 3), matrix.at(1, 3), matrix.at(2, 3), matrix.at(3, 3))) {
      return fail(
          entry("node", index),
          "its matrix looks transposed: its last column is 0 0 0 1, and its last row is not",
          "write the matrix column by column, so that the translation is in numbers 13 to "
          "15");
    }
    return fail(entry("node", index), "the last row of its matrix is not 0 0 0 1", kCorrect);
  }
  return matrix;
}

// The matrix translation * rotation * scale of a node, with this scale. The quaternion q should
// have length 1; the factor 2/|q|^2 makes a rotation from any other quaternion, too, without a
// square root.
Result<Matrix> from_trs(const tinygltf::Node& node, const std::vector<double>& scale,
                        std::size_t index) {
  const auto get = [](const std::vector<double>& v, std::size_t i, double otherwise) {
    return v.empty() ? otherwise : v[i];
  };
  const double x = get(node.rotation, 0, 0), y = get(node.rotation, 1, 0),
               z = get(node.rotation, 2, 0), w = get(node.rotation, 3, 1);
  const double norm = x * x + y * y + z * z + w * w;
  const double s = 2 / norm;
  if (!(norm > 0) || !std::isfinite(norm) || !std::isfinite(s)) {
    return fail(entry("node", index), "its rotation is a quaternion without a usable length",
                "write a unit quaternion");
  }
  const double rotation[3][3] = {
      {1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
      {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
      {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}};
  Matrix matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix.at(row, column) = rotation[row][column] * get(scale, std::size_t(column), 1);
    }
    matrix.at(row, 3) = get(node.translation, std::size_t(row), 0);
  }
  return matrix;
}

bool is_finite(const Matrix& matrix) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (!std::isfinite(matrix.at(row, column))) return false;
    }
  }
  return true;
}

// The parent of every node; kNone for roots.
Result<std::vector<std::uint32_t>> find_parents(const Asset& asset) {
  const auto& nodes = asset.model.nodes;
  std::vector<std::uint32_t> parents(nodes.size(), kNone);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      if (std::size_t(child) == i) return fail(entry("node", i), "is its own child", kCorrect);
      std::uint32_t& parent = parents[std::size_t(child)];
      if (parent != kNone) {
        return fail(
            entry("node", std::size_t(child)),
            "is named as a child twice, by " + entry("node", parent) + " and " + entry("node", i),
            kCorrect);
      }
      parent = std::uint32_t(i);
    }
  }
  return parents;
}

// All nodes below the given roots, in depth-first order: parents first, children in their order.
std::vector<std::uint32_t> walk(const Asset& asset, const std::vector<std::uint32_t>& roots) {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    order.push_back(node);
    const std::vector<int>& children = asset.model.nodes[node].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      stack.push_back(std::uint32_t(*child));
  }
  return order;
}

// The root nodes of the default scene.
Result<std::vector<std::uint32_t>> scene_roots(const Asset& asset,
                                               const std::vector<std::uint32_t>& parents,
                                               const std::vector<std::uint32_t>& all_roots,
                                               Scene& scene) {
  if (asset.model.scenes.empty()) return all_roots;
  const std::size_t chosen =
      asset.model.defaultScene < 0 ? 0 : std::size_t(asset.model.defaultScene);
  scene.name = printable(asset.model.scenes[chosen].name);
  std::vector<std::uint32_t> roots;
  std::vector<bool> seen(parents.size(), false);
  for (const int root : asset.model.scenes[chosen].nodes) {
    const std::uint32_t node = std::uint32_t(root);
    if (parents[node] != kNone) {
      return fail(entry("scene", chosen),
                  "starts at " + entry("node", node) + ", which is a child of " +
                      entry("node", parents[node]),
                  kCorrect);
    }
    if (seen[node])
      return fail(entry("scene", chosen), "names " + entry("node", node) + " twice", kCorrect);
    seen[node] = true;
    roots.push_back(node);
  }
  return roots;
}

}  // namespace

Transform<World, Object> without_scale(const tinygltf::Node& node) {
  // The matrix and the quaternion of a node that has been placed are known to be good.
  return node.matrix.empty() ? *from_trs(node, {}, 0) : *from_matrix(node.matrix, 0);
}

Result<NodeTree> place_nodes(const Asset& asset, Scene& scene) {
  const auto& nodes = asset.model.nodes;
  const auto parents = find_parents(asset);
  if (!parents) return tl::unexpected(parents.error());
  std::vector<std::uint32_t> all_roots;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if ((*parents)[i] == kNone) all_roots.push_back(std::uint32_t(i));
  }

  NodeTree tree;
  tree.world_from_node.resize(nodes.size());
  tree.scene_index.assign(nodes.size(), kNone);
  std::vector<Matrix> own(nodes.size());
  std::vector<std::uint32_t> depth(nodes.size(), 0);  // 0 for a node that was not reached
  for (const std::uint32_t node : walk(asset, all_roots)) {
    const std::uint32_t parent = (*parents)[node];
    depth[node] = parent == kNone ? 1 : depth[parent] + 1;
    if (depth[node] > asset.limits.max_node_depth) {
      return fail(
          entry("node", node),
          "is nested deeper than " + std::to_string(asset.limits.max_node_depth) + " levels",
          "use fewer levels of nodes (in the library: LoadLimits::max_node_depth)");
    }
    const auto matrix = nodes[node].matrix.empty() ? from_trs(nodes[node], nodes[node].scale, node)
                                                   : from_matrix(nodes[node].matrix, node);
    if (!matrix) return tl::unexpected(matrix.error());
    own[node] = *matrix;
    // A node without a transform gets exactly its parent's transform: a product with the identity
    // would lose the sign of -0.
    if (parent == kNone) {
      tree.world_from_node[node] = own[node];
    } else if (!has_transform(nodes[node])) {
      tree.world_from_node[node] = tree.world_from_node[parent];
    } else {
      tree.world_from_node[node] = compose(tree.world_from_node[parent], own[node]);
    }
    if (!is_finite(tree.world_from_node[node])) {
      return fail(entry("node", node), "its matrix in the world has numbers that are not finite",
                  "scale the nodes above it down");
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (depth[i] == 0) return fail(entry("node", i), "is part of a cycle of nodes", kCorrect);
  }

  const auto roots = scene_roots(asset, *parents, all_roots, scene);
  if (!roots) return tl::unexpected(roots.error());
  tree.drawn = walk(asset, *roots);
  for (const std::uint32_t node : tree.drawn) {
    tree.scene_index[node] = std::uint32_t(scene.nodes.size());
    const std::uint32_t parent = (*parents)[node];
    Node placed;
    placed.name = printable(nodes[node].name);
    placed.parent = parent == kNone ? kNone : tree.scene_index[parent];
    placed.parent_from_node = own[node];
    placed.world_from_node = tree.world_from_node[node];
    scene.nodes.push_back(std::move(placed));
  }
  return tree;
}

}  // namespace glassbox::gltf
