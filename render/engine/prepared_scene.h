// What rendering needs of a scene and no view changes: made once, rendered from many times.
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

// What the corners of the triangles have, as indices, three for each triangle one after the other: the form in which the tile
// engine's vectors read them.
struct CornerIndices {
  std::vector<std::uint32_t> positions;
  // Into the normals, and beyond them the faces: face f is entry normals.size() + f, for corners without a normal.
  std::vector<std::uint32_t> normals;    // empty: the same as the positions'
  std::vector<std::uint32_t> texcoords;  // empty: the same as the positions', or there are none
  std::vector<std::uint32_t> colors;     // likewise
  bool has_texcoords = false, has_colors = false;
  // Of the corners that triangles use, some have texture coordinates (or colours) and others none.
  bool mixed = false;
};

// Instances of a mesh may go through the tile engine together, up to so many triangles: their vertices lie one instance after the
// other in its tables.
inline constexpr std::uint32_t kJoinedTriangles = 8192;

struct PreparedMesh {
  Triangulation triangulation;
  Box<Object> bounds;
  CornerIndices indices;
  // The same for as many instances as the scene has, or as have kJoinedTriangles: the positions of instance k follow those of k - 1, and
  // so do its normals (with the faces' after them, where corners lack normals). All have the mesh's own texture coordinates and
  // colours. Empty: instances stay by themselves.
  CornerIndices joined;
  Clusters clusters;  // none where a position is not finite
  bool all_have_normals = false;
  bool all_finite = true;  // the positions that are drawn: no vertex is lost from `bounds`
};

// Belongs to the scene it was made from, which must outlive it and not change.
struct PreparedScene {
  std::vector<PreparedMesh> meshes;                     // by mesh
  std::vector<std::unique_ptr<LazyMipChain>> textures;  // by texture
  std::unique_ptr<const InstanceGroups> groups;         // null in scenes of few instances
};

// `transfer` decides how the halvings of textures are averaged: it must be that of the settings rendered with.
PreparedScene prepare(const Scene& scene, Transfer transfer);

}  // namespace glassbox
