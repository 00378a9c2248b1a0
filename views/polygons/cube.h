// Numbers of the corners, edges and faces of a cell. Bit 0 of a corner's number is its x, bit 1 its
// y, bit 2 its z.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace glassbox::views {

// An edge runs along `axis`, 0 .. 2, from the corner `from`, whose bit for that axis is 0.
struct CellEdge {
  int from = 0, axis = 0;
  constexpr int to() const { return from | 1 << axis; }
};

// Edges 4 a .. 4 a + 3 run along axis a.
constexpr std::array<CellEdge, 12> kCellEdges = [] {
  std::array<CellEdge, 12> edges{};
  std::size_t next = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) == 0) edges[next++] = {corner, axis};
    }
  }
  return edges;
}();

// The edge between two corners that differ in one bit.
constexpr int cell_edge_between(int a, int b) {
  const int low = a < b ? a : b, bit = a ^ b;
  for (std::size_t i = 0; i < kCellEdges.size(); ++i) {
    if (kCellEdges[i].from == low && 1 << kCellEdges[i].axis == bit) return int(i);
  }
  return -1;
}

// Corners of the faces, counter-clockwise seen from outside: low x, high x, low y, high y, low z,
// high z.
constexpr std::array<std::array<int, 4>, 6> kCellFaces = [] {
  std::array<std::array<int, 4>, 6> faces{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int first = 1 << (axis + 1) % 3, second = 1 << (axis + 2) % 3, high = 1 << axis;
    faces[2 * axis] = {0, second, first | second, first};
    faces[2 * axis + 1] = {high, high | first, high | first | second, high | second};
  }
  return faces;
}();

// Whether two edges of a cell are on a common face.
constexpr bool share_a_face(int edge_a, int edge_b) {
  const CellEdge a = kCellEdges[std::size_t(edge_a)], b = kCellEdges[std::size_t(edge_b)];
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == a.axis || axis == b.axis) continue;
    if ((a.from >> axis & 1) == (b.from >> axis & 1)) return true;
  }
  return false;
}

}  // namespace glassbox::views
