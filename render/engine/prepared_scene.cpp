#include <glassbox/render/engine/prepared_scene.h>

#include <algorithm>
#include <cmath>

#include <glassbox/mesh/bounding_box.h>

namespace glassbox {

namespace {

// Collects index_of(corner, triangle) for each corner of each triangle.
template <class IndexOf>
std::vector<std::uint32_t> gather_indices(const Mesh& mesh, const Triangulation& triangulation,
                                          const IndexOf& index_of) {
  std::vector<std::uint32_t> indices;
  indices.reserve(triangulation.triangles.size() * 3);
  for (const Triangle& triangle : triangulation.triangles) {
    for (const std::uint32_t corner : triangle.corners) {
      indices.push_back(index_of(mesh.corners[corner], triangle));
    }
  }
  return indices;
}

// Returns an empty list if the indices are equal to those of the positions. Then the positions'
// indices are used for both.
std::vector<std::uint32_t> unless_equal(std::vector<std::uint32_t> indices,
                                        const std::vector<std::uint32_t>& positions) {
  if (indices == positions) return {};
  indices.shrink_to_fit();
  return indices;
}

CornerIndices corner_indices(const Mesh& mesh, const Triangulation& triangulation) {
  CornerIndices indices;
  indices.positions = gather_indices(mesh, triangulation,
                                     [](const Corner& c, const Triangle&) { return c.position; });
  const auto first_face = std::uint32_t(mesh.normals.size());
  indices.normals = unless_equal(
      gather_indices(mesh, triangulation,
                     [&](const Corner& c, const Triangle& triangle) {
                       return c.normal != kNone ? c.normal : first_face + triangle.face;
                     }),
      indices.positions);
  // Gathers the indices of an attribute that some corners may not have.
  using IndexOf = std::uint32_t Corner::*;
  const auto gather_optional = [&](IndexOf member, bool& has_any) {
    std::vector<std::uint32_t> found = gather_indices(
        mesh, triangulation, [&](const Corner& c, const Triangle&) { return c.*member; });
    const auto lacking = std::size_t(std::ranges::count(found, kNone));
    has_any = lacking < found.size();
    indices.mixed = indices.mixed || (has_any && lacking > 0);
    return has_any ? unless_equal(std::move(found), indices.positions)
                   : std::vector<std::uint32_t>{};
  };
  indices.texcoords = gather_optional(&Corner::texcoord, indices.has_texcoords);
  indices.colors = gather_optional(&Corner::color, indices.has_colors);
  return indices;
}

// Returns `indices` repeated for the first `copies` instances. Each instance has `stride` table
// entries of its own, so the indices of copy k are increased by k * stride.
std::vector<std::uint32_t> repeated(const std::vector<std::uint32_t>& indices, std::size_t copies,
                                    std::size_t stride) {
  std::vector<std::uint32_t> all;
  all.reserve(indices.size() * copies);
  for (std::size_t copy = 0; copy < copies; ++copy) {
    for (const std::uint32_t index : indices) all.push_back(std::uint32_t(index + copy * stride));
  }
  return all;
}

CornerIndices joined_indices(const Mesh& mesh, const PreparedMesh& prepared, std::size_t copies) {
  const CornerIndices& one = prepared.indices;
  const auto or_positions = [&](const std::vector<std::uint32_t>& own) -> const auto& {
    return own.empty() ? one.positions : own;
  };
  const std::size_t normals =
      mesh.normals.size() + (prepared.all_have_normals ? 0 : mesh.faces.size());
  CornerIndices joined;
  joined.positions = repeated(one.positions, copies, mesh.positions.size());
  joined.normals = repeated(or_positions(one.normals), copies, normals);
  if (one.has_texcoords) joined.texcoords = repeated(or_positions(one.texcoords), copies, 0);
  if (one.has_colors) joined.colors = repeated(or_positions(one.colors), copies, 0);
  joined.has_texcoords = one.has_texcoords;
  joined.has_colors = one.has_colors;
  joined.mixed = one.mixed;
  return joined;
}

// Whether instances of the mesh are joined into one draw. Where many small meshes are drawn, most
// of the time would be the fixed cost of each draw. Meshes that have clusters are not small.
bool is_joined(const Mesh& mesh, const PreparedMesh& prepared, std::size_t instances) {
  const std::size_t triangles = prepared.triangulation.triangles.size();
  return instances > 1 && triangles > 0 && triangles <= kJoinedTriangles / 2 &&
         prepared.clusters.clusters.empty() && mesh.lines.empty() && mesh.points.empty();
}

}  // namespace

PreparedScene prepare_scene(const Scene& scene, Transfer transfer) {
  PreparedScene prepared;
  prepared.meshes.reserve(scene.meshes.size());
  std::vector<std::size_t> instances(scene.meshes.size());
  for (const Instance& instance : scene.instances) ++instances[instance.mesh];
  for (const Mesh& mesh : scene.meshes) {
    PreparedMesh& made = prepared.meshes.emplace_back();
    made.triangulation = triangulate(mesh);
    made.bounds = bounds(mesh);
    made.indices = corner_indices(mesh, made.triangulation);
    made.all_have_normals = std::ranges::none_of(
        mesh.corners, [](const Corner& corner) { return corner.normal == kNone; });
    for_each_drawn_position(mesh, [&](const Point<Object>& p) {
      made.all_finite =
          made.all_finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
    if (made.all_finite) {
      made.clusters = make_clusters(mesh, made.indices.positions, made.indices.normals);
    }
    if (const std::size_t copies = instances[prepared.meshes.size() - 1];
        is_joined(mesh, made, copies)) {
      const std::size_t most = kJoinedTriangles / made.triangulation.triangles.size();
      made.joined = joined_indices(mesh, made, std::min(copies, most));
    }
  }
  if (scene.instances.size() >= kMinGroupedInstances) {
    prepared.groups =
        std::make_unique<InstanceGroups>(make_instance_groups(scene, prepared.meshes));
  }
  for (const Texture& texture : scene.textures) {
    prepared.textures.push_back(std::make_unique<LazyMipChain>(
        scene.images[texture.image], transfer, texture.sampler.mip == MipFilter::kNone));
  }
  return prepared;
}

}  // namespace glassbox
