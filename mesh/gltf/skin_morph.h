// Morph targets at fixed weights and skins in a fixed pose, evaluated in double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/nodes.h>

namespace glassbox::gltf {

// world_from_joint * inverse bind matrix of each joint: moves vertices from the modelled pose to
// the current pose.
using JointMatrices = std::vector<Transform<World, Object>>;

Result<JointMatrices> joint_matrices(const Asset& asset, const NodeTree& tree, std::size_t skin);

// The positions and normals of one primitive before they are rounded: three numbers per vertex. The
// normals are empty if the primitive has none.
struct Vertices {
  std::vector<double> positions;
  std::vector<double> normals;
  std::size_t count() const { return positions.size() / 3; }
};

// Adds weight * delta of a morph target to every number. `deltas` has three numbers per vertex.
void add_target(std::vector<double>& numbers, const std::vector<double>& deltas, double weight);

// One set of joints: four joints and their weights for each vertex.
struct Influences {
  std::vector<double> joints;
  std::vector<double> weights;
};

// Moves each vertex by the weighted mean of its joints' matrices, and its normal by the cofactors
// of that mean, which keep it perpendicular to the surface. Weights are divided by their sum; a
// vertex without weight follows its first joint. Errors name the vertex whose joint does not exist.
Result<void> apply_skin(Vertices& vertices, const std::vector<Influences>& sets,
                        const JointMatrices& joints);

}  // namespace glassbox::gltf
