#include "views/polygons/cell_table.h"

#include <bit>
#include <optional>
#include <utility>

namespace glassbox::views {

namespace {

constexpr int kNoEdge = -1;

bool is_inside(unsigned inside, int corner) {
  return (inside >> corner & 1) != 0;
}

// For each edge of the cell that the surface crosses, the next such edge around the surface's
// polygon; kNoEdge for all other edges. On a face, seen from outside of the cell, a side of the
// polygon is the border of a stretch of inside corners. It runs from the edge where the stretch
// begins to the edge where it ends, with the inside to its right. So the polygon is
// counter-clockwise when seen from outside of the solid.
std::array<int, 12> next_edges(unsigned inside, unsigned joined) {
  std::array<int, 12> next;
  next.fill(kNoEdge);
  for (std::size_t face = 0; face < kCellFaces.size(); ++face) {
    const std::array<int, 4>& corners = kCellFaces[face];
    std::array<int, 4> crossed{};  // edges around the face that the surface crosses
    std::array<bool, 4> enters{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const int from = corners[i], to = corners[(i + 1) % 4];
      if (is_inside(inside, from) == is_inside(inside, to)) continue;
      crossed[count] = cell_edge_between(from, to);
      enters[count++] = is_inside(inside, to);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!enters[i]) continue;
      // If inside corners are cut off one by one, the stretch that begins at this edge ends at the
      // next edge that is crossed. If they are joined, the polygon's side goes around the outside
      // corner before this edge instead, and ends at the previous edge that is crossed.
      const bool is_joined = count == 4 && (joined >> face & 1) != 0;
      const std::size_t end = is_joined ? (i + count - 1) % count : (i + 1) % count;
      next[std::size_t(crossed[i])] = crossed[end];
    }
  }
  return next;
}

using Loop = std::vector<int>;

std::vector<Loop> loops_of(std::array<int, 12> next) {
  std::vector<Loop> loops;
  for (int start = 0; start < 12; ++start) {
    if (next[std::size_t(start)] == kNoEdge) continue;
    Loop loop;
    for (int at = start; next[std::size_t(at)] != kNoEdge;) {
      loop.push_back(at);
      at = std::exchange(next[std::size_t(at)], kNoEdge);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

using Triangles = std::vector<CellTriangle>;

// Divides the part of a loop from corner i to corner j into triangles, by diagonals that never have
// both ends on one face of the cell; none if this is impossible.
std::optional<Triangles> triangulate_loop(const Loop& loop, std::size_t i, std::size_t j) {
  if (j - i < 2) return Triangles();
  for (std::size_t k = i + 1; k < j; ++k) {
    const auto is_allowed = [&](std::size_t a, std::size_t b) {
      return b - a == 1 || !share_a_face(loop[a], loop[b]);
    };
    if (!is_allowed(i, k) || !is_allowed(k, j)) continue;
    auto first = triangulate_loop(loop, i, k);
    if (!first) continue;
    const auto second = triangulate_loop(loop, k, j);
    if (!second) continue;
    first->insert(first->end(), second->begin(), second->end());
    first->push_back({std::uint8_t(loop[i]), std::uint8_t(loop[k]), std::uint8_t(loop[j])});
    return first;
  }
  return std::nullopt;
}

// A fan of triangles around a point inside the cell.
Triangles fan_around_middle(const Loop& loop) {
  Triangles triangles;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int from = loop[i], to = loop[(i + 1) % loop.size()];
    triangles.push_back({std::uint8_t(from), std::uint8_t(to), std::uint8_t(kCellMiddle)});
  }
  return triangles;
}

CellTable make_table(unsigned (*joined_of)(unsigned inside)) {
  CellTable table;
  for (unsigned inside = 0; inside < table.size(); ++inside)
    table[inside] = cell_surface(inside, joined_of(inside));
  return table;
}

}  // namespace

CellSurface cell_surface(unsigned inside, unsigned joined) {
  CellSurface surface;
  for (const Loop& loop : loops_of(next_edges(inside, joined))) {
    std::optional<Triangles> triangles = triangulate_loop(loop, 0, loop.size() - 1);
    if (!triangles) triangles = fan_around_middle(loop);
    surface.triangles.insert(surface.triangles.end(), triangles->begin(), triangles->end());
  }
  return surface;
}

const CellTable& consistent_table() {
  static const CellTable table = make_table([](unsigned) { return 0u; });
  return table;
}

const CellTable& naive_table() {
  static const CellTable table =
      make_table([](unsigned inside) { return std::popcount(inside) > 4 ? 63u : 0u; });
  return table;
}

unsigned ambiguous_faces(unsigned inside) {
  unsigned faces = 0;
  for (std::size_t face = 0; face < kCellFaces.size(); ++face) {
    const std::array<int, 4>& c = kCellFaces[face];
    const bool first = is_inside(inside, c[0]), second = is_inside(inside, c[1]);
    if (first != second && first == is_inside(inside, c[2]) && second == is_inside(inside, c[3]))
      faces |= 1u << face;
  }
  return faces;
}

}  // namespace glassbox::views
