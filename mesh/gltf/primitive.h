// Converts one primitive of a glTF mesh to one Mesh: attributes to tables, modes to faces, lines
// and points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/materials.h>
#include <glassbox/mesh/gltf/skin_morph.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox::gltf {

// The number of vertices and corners that may still be made. Primitives may share accessors, so
// without a limit a short file could request any number of vertices.
class Budget {
public:
  explicit Budget(std::uint64_t elements) : size_(elements), left_(elements) {}
  std::uint64_t size() const { return size_; }
  bool take(std::uint64_t elements) {
    if (elements > left_) return false;
    left_ -= elements;
    return true;
  }

private:
  std::uint64_t size_;
  std::uint64_t left_;
};

// The position of a primitive in the file, for messages.
struct PrimitiveId {
  std::size_t mesh = 0;
  std::size_t primitive = 0;
};

// The data for drawing a primitive that are not in the primitive itself.
struct Pose {
  std::vector<double> weights;            // of the morph targets; empty: not morphed
  const JointMatrices* joints = nullptr;  // null: not skinned
};

// Returns nothing where there is nothing to draw (no positions, no data, too few vertices); then
// asset.warnings has the reason.
Result<std::optional<Mesh>> convert_primitive(Asset& asset, PrimitiveId id, const Pose& pose,
                                              const TexCoordSource& texcoords, Budget& budget);

}  // namespace glassbox::gltf
