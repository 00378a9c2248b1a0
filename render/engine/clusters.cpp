#include <glassbox/render/engine/clusters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glassbox/base/box.h>

namespace glassbox {

namespace {

Point<Object, double> to_double(const Point<Object>& p) {
  return {double(p.x), double(p.y), double(p.z)};
}

constexpr std::uint32_t kMinTriangles = 16 * kClusterTriangles;

using Vector3 = Vector<Object, double>;
using Corners = std::array<Point<Object, double>, 3>;

double length(const Vector3& v) {
  return std::sqrt(dot(v, v));
}

// A relative margin that is larger than the rounding errors of a cone: of its axis, of the normals
// and of the cosine between them.
constexpr double kSlack = 0x1p-18;
// The Newell vector of a triangle (the cross product of two edges) has a rounding error below 2^-49
// if the longest edge has length 1. If the vector itself is longer than this constant, the error of
// the unit normal is below 2^-29.
constexpr double kThinnest = 0x1p-20;
constexpr double kMinCosine = 0.125;

// The normals of a cluster's triangles and what is computed with them.
struct NewellVectors {
  std::array<Vector3, kClusterTriangles> normals;
  Vector3 sum;
  double least_newell = std::numeric_limits<double>::infinity(), longest_edge = 0;
  bool sure = true;  // every normal has an error below kSlack
};

NewellVectors newell_vectors_of(std::span<const Corners> triangles) {
  NewellVectors vectors;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const Vector3 ab = b - a, ac = c - a, bc = c - b;
    const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
    const Vector3 newell = cross(ab, ac);
    const double size = length(newell);
    const bool normal_number = size > 0x1p-500 && size < 0x1p500;
    vectors.sure = vectors.sure && normal_number && size > kThinnest * longest * longest;
    vectors.normals[i] = newell * (1 / size);
    vectors.sum = vectors.sum + newell;
    vectors.least_newell = std::min(vectors.least_newell, size);
    vectors.longest_edge = std::max(vectors.longest_edge, longest);
  }
  return vectors;
}

// Computes the cone that contains the cluster's normals. The cluster gets none if a normal is more
// than about 83 degrees from the axis (kMinCosine) or is not accurate (kThinnest).
void add_cone(std::span<const Corners> triangles, Cluster& cluster) {
  const NewellVectors vectors = newell_vectors_of(triangles);
  const double size = length(vectors.sum);
  if (!vectors.sure || !(size > 0)) return;
  const Vector3 sum = vectors.sum * (1 / size);
  cluster.axis = {float(sum.x), float(sum.y), float(sum.z)};
  cluster.least_newell = vectors.least_newell * (1 - kSlack);
  cluster.longest_edge = vectors.longest_edge * (1 + kSlack);

  const Vector3 axis = axis_of(cluster);
  const Point<Object, double> centre = centre_of(cluster);
  double cosine = 1, backs = std::numeric_limits<double>::infinity(), fronts = -backs;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vector3& normal = vectors.normals[i];
    const double along = dot(triangles[i][0] - centre, normal) / dot(axis, normal);
    cosine = std::min(cosine, dot(axis, normal));
    backs = std::min(backs, along);
    fronts = std::max(fronts, along);
  }
  if (!(cosine - kSlack > kMinCosine)) return;
  const double across = 2 * length(half_size_of(cluster));
  cluster.along_backs = backs - kSlack * across;
  cluster.along_fronts = fronts + kSlack * across;
  cluster.cosine = float(cosine - kSlack);
}

Cluster make_cluster(std::span<const Corners> triangles) {
  Box<Object> box;
  for (const Corners& corners : triangles) {
    for (const Point<Object, double>& p : corners) box.include(p);
  }
  Cluster cluster;
  // The conversion to float is exact, because the corners are floats.
  cluster.low = {float(box.low.x), float(box.low.y), float(box.low.z)};
  cluster.high = {float(box.high.x), float(box.high.y), float(box.high.z)};
  add_cone(triangles, cluster);
  return cluster;
}

// Calls visit with the number of each cluster and its corners, three indices for each triangle.
template <class Visit>
void for_each_cluster(std::span<const std::uint32_t> corners, const Visit& visit) {
  constexpr std::size_t kCorners = 3 * std::size_t(kClusterTriangles);
  for (std::size_t first = 0; first < corners.size(); first += kCorners) {
    visit(std::uint32_t(first / kCorners),
          corners.subspan(first, std::min(kCorners, corners.size() - first)));
  }
}

ClusterBlocks list_blocks(std::span<const std::uint32_t> corners, std::size_t table_size) {
  ClusterBlocks lists;
  lists.starts.push_back(0);
  std::vector<std::uint32_t> last_user(table_size / kTableBlock + 1, kNone);
  for_each_cluster(corners, [&](std::uint32_t cluster, std::span<const std::uint32_t> entries) {
    for (const std::uint32_t entry : entries) {
      if (entry >= table_size) continue;
      std::uint32_t& user = last_user[entry / kTableBlock];
      if (user != cluster) lists.blocks.push_back(entry / kTableBlock);
      user = cluster;
    }
    lists.starts.push_back(std::uint32_t(lists.blocks.size()));
  });
  return lists;
}

}  // namespace

Clusters make_clusters(const Mesh& mesh, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> normals) {
  Clusters made;
  if (corners.size() < 3 * std::size_t(kMinTriangles)) return made;
  std::vector<Corners> triangles;
  for_each_cluster(corners, [&](std::uint32_t, std::span<const std::uint32_t> entries) {
    triangles.clear();
    for (std::size_t i = 0; i < entries.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return to_double(mesh.positions[entries[i + k]]); };
      triangles.push_back({corner(0), corner(1), corner(2)});
    }
    made.clusters.push_back(make_cluster(triangles));
  });
  made.positions = list_blocks(corners, mesh.positions.size());
  made.normals = list_blocks(normals.empty() ? corners : normals, mesh.normals.size());
  return made;
}

}  // namespace glassbox
