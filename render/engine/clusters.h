// The triangles of a mesh by runs of 64, each with what is needed to ask about all of it at once: its box, the cone of its
// normals, and which vertices it has. Made once for a mesh; no view changes it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

inline constexpr std::uint32_t kClusterTriangles = 64;

// Unit normals u of triangles are taken as exact: what they round by is within the slack of the cone.
struct Cluster {
  Point<Object> low, high;  // the box of its corners

  // All u have axis . u >= cosine; 0: they look so far apart that nothing is said.
  Vector<Object> axis;  // unit, but for rounding to float
  float cosine = 0;
  // With c = centre_of(): c + along_backs axis lies behind every triangle's plane or on it, c + along_fronts axis before it.
  double along_backs = 0, along_fronts = 0;
  // Of the Newell vectors, whose lengths are twice the areas; and of the edges.
  double least_newell = 0, longest_edge = 0;
};

inline Point<Object, double> centre_of(const Cluster& c) {
  return {double(c.low.x) * 0.5 + double(c.high.x) * 0.5,
          double(c.low.y) * 0.5 + double(c.high.y) * 0.5,
          double(c.low.z) * 0.5 + double(c.high.z) * 0.5};
}
inline Vector<Object, double> half_size_of(const Cluster& c) {
  return {double(c.high.x) * 0.5 - double(c.low.x) * 0.5,
          double(c.high.y) * 0.5 - double(c.low.y) * 0.5,
          double(c.high.z) * 0.5 - double(c.low.z) * 0.5};
}
inline Vector<Object, double> axis_of(const Cluster& c) {
  return {double(c.axis.x), double(c.axis.y), double(c.axis.z)};
}

// Which entries of a table the clusters' corners have, by blocks of 64 neighbours.
inline constexpr std::uint32_t kTableBlock = 64;
struct ClusterBlocks {
  // Cluster i has entries in blocks[starts[i]] .. blocks[starts[i + 1] - 1].
  std::vector<std::uint32_t> starts, blocks;

  std::span<const std::uint32_t> of(std::size_t cluster) const {
    return std::span(blocks).subspan(starts[cluster], starts[cluster + 1] - starts[cluster]);
  }
};

struct Clusters {
  std::vector<Cluster> clusters;     // of triangles 64 i .. 64 i + 63; none for small meshes
  ClusterBlocks positions, normals;  // in the mesh's tables
};

// `corners`: three indices into the positions for each triangle, all of them finite; `normals` likewise, or empty: the same. What is
// beyond the mesh's normals is none. Meshes of fewer than 16 clusters have none: it is quicker to draw them than to ask.
Clusters make_clusters(const Mesh& mesh, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> normals);

}  // namespace glassbox
