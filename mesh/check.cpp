#include <glassbox/mesh/check.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/topology.h>
#include <glassbox/mesh/triangulate.h>

namespace glassbox {
namespace {

double largest_coordinate(const Mesh& mesh, const Face& face) {
  double largest = 0;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const Point<Object>& p = mesh.positions[mesh.corners[face.first + i].position];
    largest =
        std::max({largest, std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
  }
  return largest;
}

void check_planarity(const Mesh& mesh, MeshReport& report) {
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& face = mesh.faces[i];
    const double deviation = planarity_deviation(mesh, face);
    if (deviation <= 0x1p-22 * largest_coordinate(mesh, face)) continue;
    ++report.non_planar_faces;
    if (deviation > report.worst_planarity_deviation) {
      report.worst_planarity_deviation = deviation;
      report.worst_planarity_face = i;
    }
  }
}

// For every face, the list of its vertices in a standard order: it starts with the lowest vertex
// and goes on in the direction of that vertex's lower neighbour. Two faces that differ only in
// their starting corner or winding have equal lists.
class FaceRings {
public:
  FaceRings(const Mesh& mesh, const std::vector<std::uint32_t>& vertex_of_position) : mesh_(mesh) {
    rings_.reserve(mesh.corners.size());
    for (const Face& face : mesh.faces) {
      starts_.push_back(rings_.size());
      if (face.count == 0) continue;
      ring_.clear();
      for (std::uint32_t c = face.first; c < face.first + face.count; ++c) {
        ring_.push_back(vertex_of_position[mesh.corners[c].position]);
      }
      std::rotate(ring_.begin(), std::min_element(ring_.begin(), ring_.end()), ring_.end());
      if (ring_.size() > 2 && ring_.back() < ring_[1]) std::reverse(ring_.begin() + 1, ring_.end());
      rings_.insert(rings_.end(), ring_.begin(), ring_.end());
    }
    starts_.push_back(rings_.size());
  }

  std::uint32_t count_duplicates() const {
    std::vector<std::uint32_t> order(mesh_.faces.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::lexicographical_compare(begin(a), end(a), begin(b), end(b));
    });
    std::uint32_t duplicates = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
      const std::uint32_t a = order[i - 1], b = order[i];
      duplicates += std::equal(begin(a), end(a), begin(b), end(b));
    }
    return duplicates;
  }

private:
  const std::uint32_t* begin(std::uint32_t face) const { return rings_.data() + starts_[face]; }
  const std::uint32_t* end(std::uint32_t face) const { return rings_.data() + starts_[face + 1]; }

  const Mesh& mesh_;
  std::vector<std::uint32_t> ring_;
  std::vector<std::uint32_t> rings_;
  std::vector<std::size_t> starts_;
};

std::uint32_t count_quads_in_z_order(const Mesh& mesh, const Triangulation& triangulation) {
  Mesh exchanged;
  for (const auto* faces : {&triangulation.degenerate_faces, &triangulation.fallback_faces}) {
    for (const std::uint32_t index : *faces) {
      const Face& face = mesh.faces[index];
      if (face.count != 4) continue;
      const auto first = std::uint32_t(exchanged.positions.size());
      for (std::uint32_t i = 0; i < 4; ++i) {
        exchanged.positions.push_back(mesh.positions[mesh.corners[face.first + i].position]);
      }
      exchanged.faces.push_back({first, 4});
      for (const std::uint32_t i : {0u, 1u, 3u, 2u}) exchanged.corners.push_back({first + i});
    }
  }
  const Triangulation proper = triangulate(exchanged);
  return std::uint32_t(exchanged.faces.size() - proper.degenerate_faces.size() -
                       proper.fallback_faces.size());
}

}  // namespace

MeshReport mesh_report(const Mesh& mesh) {
  MeshReport report;
  report.positions = std::uint32_t(mesh.positions.size());
  report.faces = std::uint32_t(mesh.faces.size());
  report.lines = std::uint32_t(mesh.lines.size());
  report.points = std::uint32_t(mesh.points.size());
  report.bounds = bounds(mesh);
  for (const Face& face : mesh.faces) report.area += face_area(mesh, face);

  const Topology topology = find_topology(mesh, Weld::kByCoordinates);
  report.vertices = topology.vertices;
  report.edges = std::uint32_t(topology.edges.size());
  report.open_edges = topology.boundary_edges;
  report.non_manifold_edges = topology.non_manifold_edges;
  report.inconsistent_edges = topology.inconsistent_edges;
  report.pinched_vertices = topology.pinched_vertices;
  report.unused_positions = topology.unused_positions;
  report.components = topology.components;
  report.euler_characteristic = topology.euler_characteristic();
  report.closed = topology.closed();
  report.genus = topology.genus();

  const Triangulation triangulation = triangulate(mesh);
  report.triangles = std::uint32_t(triangulation.triangles.size());
  report.degenerate_faces = std::uint32_t(triangulation.degenerate_faces.size());
  report.degenerate_triangles = triangulation.degenerate_triangles;
  report.self_intersecting_faces = std::uint32_t(triangulation.fallback_faces.size());
  report.quads_in_z_order = count_quads_in_z_order(mesh, triangulation);
  report.duplicate_faces = FaceRings(mesh, topology.vertex_of_position).count_duplicates();
  check_planarity(mesh, report);
  return report;
}

}  // namespace glassbox
