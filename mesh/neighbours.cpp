#include <glassbox/mesh/neighbours.h>

#include <algorithm>
#include <tuple>

namespace glassbox {

namespace {

// A number of the list with this index. Lists are sorted by `order`, then by the numbers.
struct Entry {
  std::uint32_t list, order, number;
  friend bool operator==(const Entry&, const Entry&) = default;
};

NumberLists lists_of(std::vector<Entry> entries, std::size_t count) {
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.list, a.order, a.number) < std::tie(b.list, b.order, b.number);
  });
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  NumberLists lists;
  lists.first.assign(count + 1, 0);
  for (const Entry& entry : entries) {
    ++lists.first[entry.list + 1];
    lists.numbers.push_back(entry.number);
  }
  for (std::size_t i = 0; i < count; ++i) lists.first[i + 1] += lists.first[i];
  return lists;
}

}  // namespace

Neighbours find_neighbours(const Mesh& mesh, const Topology& topology) {
  std::vector<Entry> vertex_faces, vertex_edges, face_edges;
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    for (const std::uint32_t vertex : {edge.low, edge.high}) {
      vertex_edges.push_back({vertex, 0, e});
      for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i)
        vertex_faces.push_back({vertex, 0, topology.uses[i].face});
    }
    for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i)
      face_edges.push_back({topology.uses[i].face, topology.uses[i].corner, e});
  }
  return {lists_of(std::move(vertex_faces), mesh.positions.size()),
          lists_of(std::move(vertex_edges), mesh.positions.size()),
          lists_of(std::move(face_edges), mesh.faces.size())};
}

std::vector<std::uint32_t> faces_beside(const Topology& topology, const Neighbours& neighbours,
                                        std::uint32_t face) {
  std::vector<std::uint32_t> beside;
  for (const std::uint32_t e : neighbours.edges_of_face[face]) {
    const Edge& edge = topology.edges[e];
    for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i) {
      if (topology.uses[i].face != face) beside.push_back(topology.uses[i].face);
    }
  }
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  return beside;
}

}  // namespace glassbox
