// Clusters: groups of 64 consecutive triangles of a mesh. Each has what is needed to decide about
// all its triangles at once: its box, the cone of its normals, and which vertices it uses. Clusters
// are made once for a mesh; they do not depend on the view.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

inline constexpr std::uint32_t kClusterTriangles = 64;

// Consecutive triangles of a mesh. The comments below treat the triangles' unit normals u as exact,
// because the cone has a margin (kSlack in clusters.cpp) that covers their rounding errors.
struct Cluster {
  Point<Object> low, high;  // the bounding box of its triangles

  // Each unit normal u of the triangles has axis . u >= cosine. A cosine of 0 means that the
  // normals point in too many directions for a cone.
  Vector<Object> axis;  // of unit length, except for rounding to float
  float cosine = 0;
  // Two points on the line along the axis through the box's centre c (centre_of): c + along_backs
  // axis is behind the plane of every triangle or on it, c + along_fronts axis is in front of every
  // plane or on it.
  double along_backs = 0, along_fronts = 0;
  // The length of the shortest Newell vector (twice its triangle's area), and the longest edge.
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

// Which entries of a mesh's table of positions or normals each cluster uses, as blocks of 64
// consecutive entries.
inline constexpr std::uint32_t kTableBlock = 64;
struct ClusterBlocks {
  // Cluster i uses blocks[starts[i]] .. blocks[starts[i + 1] - 1].
  std::vector<std::uint32_t> starts, blocks;

  std::span<const std::uint32_t> of_cluster(std::size_t cluster) const {
    return std::span(blocks).subspan(starts[cluster], starts[cluster + 1] - starts[cluster]);
  }
};

struct Clusters {
  // Cluster i has triangles 64 i .. 64 i + 63 of the mesh. The list is empty for small meshes.
  std::vector<Cluster> clusters;
  ClusterBlocks positions, normals;  // blocks of the mesh's positions and normals
};

// Makes the clusters of a mesh. `corners` has three indices into the positions for each triangle;
// all these positions are finite. `normals` has the indices into the normals, or is empty if they
// are equal to `corners`; an index beyond the mesh's normals means that the corner has none. A mesh
// of fewer than 16 * 64 triangles gets no clusters: drawing it is quicker than testing clusters.
Clusters make_clusters(const Mesh& mesh, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> normals);

}  // namespace glassbox
