// The data that rendering computes from a scene independently of the view. It is made once and used
// for many pictures.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glassbox/base/box.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/mesh/triangulate.h>
#include <glassbox/raster/texture.h>
#include <glassbox/render/engine/clusters.h>
#include <glassbox/render/engine/instance_groups.h>

namespace glassbox {

// For each attribute, the indices of the triangles' corners into its table: three indices for each
// triangle, one triangle after the other. The tile engine's vectorised code reads them in this
// form.
struct CornerIndices {
  std::vector<std::uint32_t> positions;
  // Indices into the table of normals, which the normals of the faces follow: index normals.size()
  // + f is the normal of face f, for corners without a normal.
  std::vector<std::uint32_t> normals;    // empty: the same as the positions' indices
  std::vector<std::uint32_t> texcoords;  // empty: the same as for positions, or there are none
  std::vector<std::uint32_t> colors;     // empty: the same as for positions, or there are none
  bool has_texcoords = false, has_colors = false;
  // Whether some of the corners have texture coordinates (or colours) and others have none.
  bool mixed = false;
};

// The tile engine may draw several instances of a small mesh together, with at most this many
// triangles in all. In its tables the instances' vertices are stored one instance after the other.
inline constexpr std::uint32_t kJoinedTriangles = 8192;

struct PreparedMesh {
  Triangulation triangulation;
  Box<Object> bounds;
  CornerIndices indices;
  // The corners' indices for several instances together: for all that the scene has, or as many as
  // have kJoinedTriangles in all. The positions of instance k follow those of instance k - 1, and
  // so do its normals (followed by the faces' normals, where corners have none). All instances
  // share the mesh's texture coordinates and colours. Empty: instances are not joined.
  CornerIndices joined;
  Clusters clusters;  // none if a position is not finite
  bool all_have_normals = false;
  // All positions that are drawn are finite, so `bounds` includes every vertex.
  bool all_finite = true;
};

// Refers to the scene it was made from, which must outlive it and not change.
struct PreparedScene {
  std::vector<PreparedMesh> meshes;                     // one for each mesh of the scene
  std::vector<std::unique_ptr<LazyMipChain>> textures;  // one for each texture of the scene
  std::unique_ptr<const InstanceGroups> groups;         // null in scenes of few instances
};

// `transfer` is the function that decodes textures before the levels of their mip chains are
// averaged. It must be the transfer function of the settings that the scene is rendered with.
PreparedScene prepare_scene(const Scene& scene, Transfer transfer);

}  // namespace glassbox
