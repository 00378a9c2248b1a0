#include <glassbox/mesh/topology.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace glassbox {
namespace {

// Sets that can only be merged; the root of a set is its lowest member.
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void merge(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> parent_;
};

std::vector<std::uint32_t> weld_positions(const Mesh& mesh, Weld weld) {
  std::vector<std::uint32_t> vertex(mesh.positions.size());
  std::iota(vertex.begin(), vertex.end(), 0u);
  if (weld == Weld::kByIndex) return vertex;

  const auto key = [&](std::uint32_t i) {
    const Point<Object>& p = mesh.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> order = vertex;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(key(a), a) < std::tuple(key(b), b);
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (key(order[i]) == key(order[i - 1])) vertex[order[i]] = vertex[order[i - 1]];
  }
  return vertex;
}

// One face's use of an edge together with the edge's two vertices, before the uses are grouped by
// edge.
struct Passage {
  std::uint32_t low, high;
  EdgeUse use;
  std::uint32_t end_corner;  // the corner at which the passage ends
};

class Finder {
public:
  Finder(const Mesh& mesh, Weld weld)
      : mesh_(mesh), same_fan_(mesh.corners.size()), connected_(mesh.faces.size()) {
    result_.vertex_of_position = weld_positions(mesh, weld);
  }

  Topology run() {
    for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) read_face(face);
    std::sort(passages_.begin(), passages_.end(), [](const Passage& a, const Passage& b) {
      return std::tie(a.low, a.high, a.use.face, a.use.corner) <
             std::tie(b.low, b.high, b.use.face, b.use.corner);
    });
    gather_edges();
    count_components();
    count_vertices();
    count_unused();
    return std::move(result_);
  }

private:
  std::uint32_t vertex(std::uint32_t corner) const {
    return result_.vertex_of_position[mesh_.corners[corner].position];
  }

  void read_face(std::uint32_t face) {
    const Face& f = mesh_.faces[face];
    ring_.clear();
    for (std::uint32_t c = f.first; c < f.first + f.count; ++c) {
      if (ring_.empty() || vertex(ring_.back()) != vertex(c)) ring_.push_back(c);
    }
    while (ring_.size() > 1 && vertex(ring_.front()) == vertex(ring_.back())) ring_.pop_back();
    // A face is ignored unless its ring has a vertex that differs from the first two (neighbours in
    // the ring always differ).
    const auto is_third = [&](std::uint32_t c) {
      return vertex(c) != vertex(ring_[0]) && vertex(c) != vertex(ring_[1]);
    };
    if (ring_.size() < 3 || std::none_of(ring_.begin(), ring_.end(), is_third)) return;

    ++result_.faces;
    taking_part_.push_back(face);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const std::uint32_t from = ring_[i], to = ring_[i + 1 == ring_.size() ? 0 : i + 1];
      const std::uint32_t a = vertex(from), b = vertex(to);
      passages_.push_back({std::min(a, b), std::max(a, b), {face, from, a < b}, to});
      ring_corners_.push_back(from);
    }
  }

  void gather_edges() {
    result_.uses.reserve(passages_.size());
    for (std::size_t begin = 0, end = 0; begin < passages_.size(); begin = end) {
      while (end < passages_.size() && passages_[end].low == passages_[begin].low &&
             passages_[end].high == passages_[begin].high) {
        result_.uses.push_back(passages_[end].use);
        connected_.merge(passages_[begin].use.face, passages_[end].use.face);
        ++end;
      }
      const Edge edge = {passages_[begin].low, passages_[begin].high, std::uint32_t(begin),
                         std::uint32_t(end - begin)};
      result_.edges.push_back(edge);
      result_.boundary_edges += edge.boundary();
      result_.non_manifold_edges += edge.non_manifold();
      if (edge.count == 2) join_fans(passages_[begin], passages_[begin + 1]);
    }
  }

  // Two faces that share an edge are neighbours in the fans around both ends of the edge.
  void join_fans(const Passage& a, const Passage& b) {
    const bool same_direction = a.use.ascending == b.use.ascending;
    result_.inconsistent_edges += same_direction;
    same_fan_.merge(a.use.corner, same_direction ? b.use.corner : b.end_corner);
    same_fan_.merge(a.end_corner, same_direction ? b.end_corner : b.use.corner);
  }

  void count_components() {
    for (const std::uint32_t face : taking_part_)
      result_.components += connected_.root(face) == face;
  }

  void count_vertices() {
    std::vector<std::uint32_t> fan_of(mesh_.positions.size(), kNone);
    std::vector<bool> pinched(mesh_.positions.size(), false);
    for (const std::uint32_t corner : ring_corners_) {
      const std::uint32_t v = vertex(corner), fan = same_fan_.root(corner);
      if (fan_of[v] == kNone) {
        fan_of[v] = fan;
        ++result_.vertices;
      } else if (fan_of[v] != fan && !pinched[v]) {
        pinched[v] = true;
        ++result_.pinched_vertices;
      }
    }
  }

  void count_unused() {
    std::vector<bool> used(mesh_.positions.size(), false);
    for (const Face& f : mesh_.faces) {
      for (std::uint32_t i = 0; i < f.count; ++i) used[mesh_.corners[f.first + i].position] = true;
    }
    for (const auto& line : mesh_.lines) {
      for (const Corner& c : line) used[c.position] = true;
    }
    for (const Corner& c : mesh_.points) used[c.position] = true;
    result_.unused_positions = std::uint32_t(std::count(used.begin(), used.end(), false));
  }

  const Mesh& mesh_;
  Topology result_;
  std::vector<std::uint32_t> ring_;  // corners of the current face without repeated neighbours
  std::vector<std::uint32_t> ring_corners_;  // of all faces that are not ignored
  std::vector<std::uint32_t> taking_part_;
  std::vector<Passage> passages_;
  DisjointSets same_fan_;   // one set for the corners of each fan
  DisjointSets connected_;  // one set for the faces of each component
};

}  // namespace

std::optional<std::uint32_t> Topology::genus() const {
  if (!closed() || inconsistent_edges > 0 || pinched_vertices > 0) return std::nullopt;
  return std::uint32_t(std::int64_t(components) - euler_characteristic() / 2);
}

Topology find_topology(const Mesh& mesh, Weld weld) {
  return Finder(mesh, weld).run();
}

}  // namespace glassbox
