#include "views/polygons/mesh_check.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace glassbox::views {

namespace {

// A side of a triangle: its two corners in ascending order, and whether the triangle runs along it
// from the lower to the higher one.
struct Side {
  std::uint32_t low, high;
  bool forward;
  friend auto operator<=>(const Side&, const Side&) = default;
};

std::int64_t duplicates_of(const std::vector<Vector3d>& positions) {
  std::vector<std::array<double, 3>> places;
  places.reserve(positions.size());
  for (const Vector3d& p : positions) places.push_back({p.x(), p.y(), p.z()});
  std::ranges::sort(places);
  std::int64_t duplicates = 0;
  for (std::size_t i = 1; i < places.size(); ++i) duplicates += places[i] == places[i - 1];
  return duplicates;
}

// Counts corners around which the triangles do not form a single ring. In the ring around a corner,
// each triangle leads from its next corner to its last one, where another triangle begins.
std::int64_t pinched_of(const PolygonMesh& mesh) {
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> around(mesh.positions.size());
  for (const PolygonCorners& p : mesh.polygons) {
    for (std::size_t k = 0; k < 3; ++k) around[p[k]].emplace_back(p[(k + 1) % 3], p[(k + 2) % 3]);
  }
  std::int64_t pinched = 0;
  for (const auto& ring : around) {
    if (ring.empty()) continue;
    std::uint32_t at = ring.front().first;
    std::size_t steps = 0;
    do {
      const auto next =
          std::ranges::find(ring, at, &std::pair<std::uint32_t, std::uint32_t>::first);
      if (next == ring.end()) break;
      at = next->second;
      ++steps;
    } while (at != ring.front().first && steps <= ring.size());
    pinched += steps != ring.size();
  }
  return pinched;
}

}  // namespace

MeshCheck check_mesh(const PolygonMesh& mesh) {
  MeshCheck check;
  std::vector<Side> sides;
  sides.reserve(3 * mesh.polygons.size());
  std::vector<bool> used(mesh.positions.size(), false);
  for (const PolygonCorners& p : mesh.polygons) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = p[k], b = p[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b});
      used[a] = true;
    }
    const Vector3d &a = mesh.positions[p[0]], &b = mesh.positions[p[1]], &c = mesh.positions[p[2]];
    const Vector3d normal = (b - a).cross(c - a);
    check.degenerate += normal.isZero(0);
    check.volume += a.dot(b.cross(c)) / 6;
  }
  std::ranges::sort(sides);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    int forward = 0;
    for (; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;
         ++end)
      forward += sides[end].forward;
    const std::size_t count = end - i;
    ++check.edges;
    check.holes += count == 1;
    check.non_manifold_edges += count > 2;
    check.misoriented_edges += count == 2 && forward != 1;
    i = end;
  }
  check.corners = std::ranges::count(used, true);
  check.euler = check.corners - check.edges + std::int64_t(mesh.polygons.size());
  check.duplicates = duplicates_of(mesh.positions);
  check.pinched = pinched_of(mesh);
  return check;
}

}  // namespace glassbox::views
