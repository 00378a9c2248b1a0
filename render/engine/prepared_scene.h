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

// The corners of the triangles as indices into the tables of attributes, three for each triangle
// one after the other: the form in which the tile engine's vector code reads them.
struct CornerIndices {
  std::vector<std::uint32_t> positions;
  // Indices into the normals, followed by the faces: entry normals.size() + f is face f, for
  // corners without a normal.
  std::vector<std::uint32_t> normals;    // empty: equal to the positions' indices
  std::vector<std::uint32_t> texcoords;  // empty: equal to the positions', or there are none
  std::vector<std::uint32_t> colors;     // likewise
  bool has_texcoords = false, has_colors = false;
  // Some of the corners used have texture coordinates (or colours) and others have none.
  bool mixed = false;
};

// Instances of a mesh may go through the tile engine together, up to this many triangles. In its
// tables their vertices are stored one instance after the other.
inline constexpr std::uint32_t kJoinedTriangles = 8192;

struct PreparedMesh {
  Triangulation triangulation;
  Box<Object> bounds;
  CornerIndices indices;
  // The same for several instances together: all that the scene has, or as many as have
  // kJoinedTriangles. The positions of instance k follow those of k - 1, and so do its normals
  // (followed by the faces' normals, where corners have none). All instances share the mesh's
  // texture coordinates and colours. Empty: instances are not joined.
  CornerIndices joined;
  Clusters clusters;  // none where a position is not finite
  bool all_have_normals = false;
  // All positions that are drawn are finite, so `bounds` includes every vertex.
  bool all_finite = true;
};

// Refers to the scene it was made from, which must outlive it and not change.
struct PreparedScene {
  std::vector<PreparedMesh> meshes;                     // by mesh
  std::vector<std::unique_ptr<LazyMipChain>> textures;  // by texture
  std::unique_ptr<const InstanceGroups> groups;         // null in scenes of few instances
};

// `transfer` decides how the halvings of textures are averaged: it must be the transfer of the
// settings rendered with.
PreparedScene prepare_scene(const Scene& scene, Transfer transfer);

}  // namespace glassbox
