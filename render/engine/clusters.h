// Clusters: runs of 64 triangles of a mesh. Each has what is needed to decide about all its
// triangles at once: its box, the cone of its normals, and which vertices it uses. Made once for a
// mesh; they do not depend on the view.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

inline constexpr std::uint32_t kClusterTriangles = 64;

// A run of triangles. Their unit normals u count as exact: their rounding errors are within the
// slack of the cone.
struct Cluster {
  Point<Object> low, high;  // the box of its corners

  // All u have axis . u >= cosine. 0: the normals point in too many directions for a cone.
  Vector<Object> axis;  // of unit length, except for rounding to float
  float cosine = 0;
  // With c = centre_of(): c + along_backs axis is behind every triangle's plane or on it, c +
  // along_fronts axis is in front of every plane or on it.
  double along_backs = 0, along_fronts = 0;
  // The shortest Newell vector (its length is twice the triangle's area), and the longest edge.
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

// The entries of a table that the clusters' corners use, as blocks of 64 consecutive entries.
inline constexpr std::uint32_t kTableBlock = 64;
struct ClusterBlocks {
  // Cluster i has entries in blocks[starts[i]] .. blocks[starts[i + 1] - 1].
  std::vector<std::uint32_t> starts, blocks;

  std::span<const std::uint32_t> of_cluster(std::size_t cluster) const {
    return std::span(blocks).subspan(starts[cluster], starts[cluster + 1] - starts[cluster]);
  }
};

struct Clusters {
  // Cluster i has triangles 64 i .. 64 i + 63; empty for small meshes.
  std::vector<Cluster> clusters;
  ClusterBlocks positions, normals;  // blocks of the mesh's tables of positions and normals
};

// `corners`: three indices into the positions for each triangle; all these positions are finite.
// `normals`: likewise into the normals, or empty if they are equal to `corners`; an index beyond
// the mesh's normals means that the corner has none. Meshes of fewer than 16 clusters get no
// clusters: it is quicker to draw them than to test clusters.
Clusters make_clusters(const Mesh& mesh, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> normals);

}  // namespace glassbox
