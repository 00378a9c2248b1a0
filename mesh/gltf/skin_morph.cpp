#include <glassbox/mesh/gltf/skin_morph.h>

#include <array>
#include <string>

#include <glassbox/mesh/gltf/accessors.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using Matrix = Transform<World, Object>;

Result<std::vector<Matrix>> inverse_bind_matrices(const Asset& asset, std::size_t skin) {
  const tinygltf::Skin& described = asset.model.skins[skin];
  std::vector<Matrix> matrices(described.joints.size());
  if (described.inverseBindMatrices < 0) return matrices;
  const std::size_t index = std::size_t(described.inverseBindMatrices);
  const tinygltf::Accessor& accessor = asset.model.accessors[index];
  const auto refuse = [&](std::string cause) {
    return fail(entry("skin", skin), std::move(cause), "export the skin again");
  };
  if (accessor.type != TINYGLTF_TYPE_MAT4 ||
      accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
    return refuse("its inverse bind matrices in " + entry("accessor", index) +
                  " are not 4x4 matrices of floats");
  }
  if (accessor.count < matrices.size()) {
    return refuse("has " + std::to_string(matrices.size()) + " joints but " +
                  std::to_string(accessor.count) + " inverse bind matrices");
  }
  const auto numbers = read_numbers(asset, index);
  if (!numbers) return tl::unexpected(numbers.error());
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row)
        matrices[i].at(row, column) = (*numbers)[i * 16 + std::size_t(column * 4 + row)];
    }
  }
  return matrices;
}

// The weighted mean of the joints' matrices, which moves one vertex.
Result<Matrix> blend(std::size_t vertex, const std::vector<Influences>& sets,
                     const JointMatrices& joints) {
  double sum = 0;
  for (const Influences& set : sets) {
    for (std::size_t i = 0; i < 4; ++i) sum += set.weights[vertex * 4 + i];
  }
  Matrix mean(glm::dmat4(0.0));
  for (const Influences& set : sets) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double given = set.weights[vertex * 4 + i];
      const bool first = &set == &sets.front() && i == 0;
      const double weight = sum > 0 ? given / sum : first ? 1.0 : 0.0;
      if (weight == 0) continue;
      const std::size_t joint = std::size_t(set.joints[vertex * 4 + i]);
      if (joint >= joints.size()) {
        return fail("vertex " + std::to_string(vertex),
                    "follows joint " + std::to_string(joint) + ", but its skin has only " +
                        std::to_string(joints.size()) + " joints (numbers start at 0)",
                    "export the skin again");
      }
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
          mean.at(row, column) += weight * joints[joint].at(row, column);
      }
    }
  }
  return mean;
}

// Transforms the normal n by the cofactors of the upper 3x3 part of m. They are det(m) times the
// inverse transposed matrix, and need no division.
std::array<double, 3> transform_normal(const Matrix& m, const double* n) {
  std::array<double, 3> out;
  for (int row = 0; row < 3; ++row) {
    const int r1 = (row + 1) % 3, r2 = (row + 2) % 3;
    double sum = 0;
    for (int column = 0; column < 3; ++column) {
      const int c1 = (column + 1) % 3, c2 = (column + 2) % 3;
      sum += (m.at(r1, c1) * m.at(r2, c2) - m.at(r1, c2) * m.at(r2, c1)) * n[column];
    }
    out[std::size_t(row)] = sum;
  }
  return out;
}

}  // namespace

Result<JointMatrices> joint_matrices(const Asset& asset, const NodeTree& tree, std::size_t skin) {
  auto matrices = inverse_bind_matrices(asset, skin);
  if (!matrices) return tl::unexpected(matrices.error());
  const std::vector<int>& joints = asset.model.skins[skin].joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    (*matrices)[i] = compose(tree.world_from_node[std::size_t(joints[i])], (*matrices)[i]);
  }
  return std::move(*matrices);
}

void add_target(std::vector<double>& numbers, const std::vector<double>& deltas, double weight) {
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] += weight * deltas[i];
}

Result<void> apply_skin(Vertices& vertices, const std::vector<Influences>& sets,
                        const JointMatrices& joints) {
  for (std::size_t vertex = 0; vertex < vertices.count(); ++vertex) {
    const auto world_from_vertex = blend(vertex, sets, joints);
    if (!world_from_vertex) return tl::unexpected(world_from_vertex.error());
    double* const p = vertices.positions.data() + vertex * 3;
    const Point<World, double> moved = *world_from_vertex * Point<Object, double>(p[0], p[1], p[2]);
    p[0] = moved.x;
    p[1] = moved.y;
    p[2] = moved.z;
    if (vertices.normals.empty()) continue;
    double* const n = vertices.normals.data() + vertex * 3;
    const std::array<double, 3> turned = transform_normal(*world_from_vertex, n);
    for (std::size_t i = 0; i < 3; ++i) n[i] = turned[i];
  }
  return {};
}

}  // namespace glassbox::gltf
