// Tables of neighbours, as a modeller draws them on paper: which faces and edges touch a vertex,
// and which edges a face has. They follow from the topology (S4-17).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/mesh/mesh.h>
#include <glassbox/mesh/topology.h>

namespace glassbox {

// Lists of numbers, one after the other in one table: list i is numbers[first[i]] to
// numbers[first[i + 1] - 1].
struct NumberLists {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> numbers;

  std::size_t size() const { return first.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(numbers).subspan(first[i], first[i + 1] - first[i]);
  }
};

// Vertices, faces and edges have the numbers of the topology. A face that the topology ignores (it
// has fewer than three different vertices) touches nothing, and its lists are empty.
struct Neighbours {
  // By position. A position that is welded to another one has empty lists.
  NumberLists faces_of_vertex;  // ascending, each face once
  NumberLists edges_of_vertex;  // ascending, each edge once
  // In the order in which the face's outline passes along them. An edge that it passes twice is
  // listed twice.
  NumberLists edges_of_face;
};

// `topology` is that of the mesh. Takes O(n log n) in the number of corners.
Neighbours find_neighbours(const Mesh& mesh, const Topology& topology);

// The other faces at the edges of a face: ascending, each once. If one face is in the list of
// another, the other is in its own list. Takes O(n log n) in the number of uses of these edges.
std::vector<std::uint32_t> faces_beside(const Topology& topology, const Neighbours& neighbours,
                                        std::uint32_t face);

}  // namespace glassbox
