#include <glassbox/mesh/gltf/unified_mesh.h>

#include <array>
#include <span>
#include <string>
#include <unordered_map>

#include <glassbox/mesh/gltf/text.h>
#include <glassbox/mesh/triangulate.h>

namespace glassbox::gltf {
namespace {

struct CornerHash {
  std::size_t operator()(const Corner& c) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t index : {c.position, c.normal, c.texcoord, c.color}) {
      hash = (hash ^ index) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return std::size_t(hash);
  }
};

// Adds triangles, lines and points to the last primitive as long as they have the same attributes;
// otherwise it starts another primitive.
class Unifier {
public:
  void add(int mode, bool has_normals, std::span<const Corner> corners) {
    bool has_texcoords = false, has_colors = false;
    for (const Corner& corner : corners) {
      has_texcoords = has_texcoords || corner.texcoord != kNone;
      has_colors = has_colors || corner.color != kNone;
    }
    if (primitives_.empty() || primitives_.back().mode != mode ||
        primitives_.back().has_normals != has_normals ||
        primitives_.back().has_texcoords != has_texcoords ||
        primitives_.back().has_colors != has_colors) {
      primitives_.push_back({mode, has_normals, has_texcoords, has_colors, {}, {}});
      numbers_.clear();
    }
    UnifiedPrimitive& primitive = primitives_.back();
    for (Corner corner : corners) {
      if (!has_normals) corner.normal = kNone;
      const auto [known, is_new] =
          numbers_.try_emplace(corner, std::uint32_t(primitive.vertices.size()));
      if (is_new) primitive.vertices.push_back(corner);
      primitive.indices.push_back(known->second);
    }
  }
  std::vector<UnifiedPrimitive> take() { return std::move(primitives_); }

private:
  std::vector<UnifiedPrimitive> primitives_;
  std::unordered_map<Corner, std::uint32_t, CornerHash> numbers_;
};

}  // namespace

Result<std::vector<UnifiedPrimitive>> unify(const Mesh& mesh) {
  Unifier unifier;
  for (const Triangle& triangle : triangulate(mesh).triangles) {
    std::array<Corner, 3> corners;
    int normals = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = mesh.corners[triangle.corners[i]];
      normals += corners[i].normal == kNone ? 0 : 1;
    }
    if (normals != 0 && normals != 3) {
      return fail("mesh " + in_quotes(mesh.name) + ", face " + std::to_string(triangle.face),
                  "has normals on some of its corners only, which glTF cannot hold",
                  "give all of its corners normals, or none");
    }
    unifier.add(4, normals == 3, corners);
  }
  for (const std::array<Corner, 2>& line : mesh.lines) {
    unifier.add(1, line[0].normal != kNone && line[1].normal != kNone, line);
  }
  for (const Corner& point : mesh.points) unifier.add(0, point.normal != kNone, {&point, 1});
  return unifier.take();
}

}  // namespace glassbox::gltf
