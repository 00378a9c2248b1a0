// Reduces the number of triangles of a mesh: edges are collapsed, starting with the one that moves
// the surface least (Garland and Heckbert 1997).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include <glassbox/mesh/mesh.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace glassbox::study::d26 {

using Triangle = std::array<std::uint32_t, 3>;

// The sum of the squared distances of a point x to planes n . x + d = 0, as x A x + 2 b x + c.
class Quadric {
public:
  static Quadric of_plane(const glm::dvec3& normal, double offset, double weight) {
    Quadric q;
    q.a_ = {normal.x * normal.x, normal.y * normal.y, normal.z * normal.z,
            normal.x * normal.y, normal.y * normal.z, normal.z * normal.x};
    for (double& each : q.a_) each *= weight;
    q.b_ = normal * (offset * weight);
    q.c_ = offset * offset * weight;
    return q;
  }
  Quadric& operator+=(const Quadric& other) {
    for (std::size_t i = 0; i < 6; ++i) a_[i] += other.a_[i];
    b_ += other.b_, c_ += other.c_;
    return *this;
  }
  double at(const glm::dvec3& p) const {
    const auto& [xx, yy, zz, xy, yz, zx] = a_;
    return xx * p.x * p.x + yy * p.y * p.y + zz * p.z * p.z +
           2 * (xy * p.x * p.y + yz * p.y * p.z + zx * p.z * p.x) + 2 * glm::dot(b_, p) + c_;
  }

private:
  std::array<double, 6> a_{};  // order of the entries: xx, yy, zz, xy, yz, zx
  glm::dvec3 b_{0, 0, 0};
  double c_ = 0;
};

// Corners at the same place count as one vertex. A remaining vertex stays at its place and replaces
// those that were collapsed into it.
class Decimation {
public:
  explicit Decimation(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, std::uint32_t> known;
    std::vector<std::uint32_t> vertex_of;
    for (const auto& p : mesh.positions) {
      const auto [at, added] = known.try_emplace({p.x, p.y, p.z}, std::uint32_t(places_.size()));
      if (added) places_.emplace_back(p.x, p.y, p.z);
      vertex_of.push_back(at->second);
    }
    around_.resize(places_.size());
    for (const Face& face : mesh.faces) {
      Triangle t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = vertex_of[mesh.corners[face.first + k].position];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;  // no area, at a pole
      for (const std::uint32_t v : t) around_[v].push_back(std::uint32_t(triangles_.size()));
      triangles_.push_back(t);
    }
    left_ = triangles_.size();
    into_.resize(places_.size());
    for (std::uint32_t v = 0; v < into_.size(); ++v) into_[v] = v;
    make_quadrics();
    for (std::uint32_t v = 0; v < places_.size(); ++v) add_candidates_at(v);
  }

  // Collapses edges until this many triangles are left, or until no more edge can be collapsed.
  void reduce_to(std::size_t triangles) {
    while (left_ > triangles && !candidates_.empty()) {
      const CollapseCandidate candidate = candidates_.top();
      candidates_.pop();
      if (candidate.version != versions_[candidate.gone] + versions_[candidate.kept]) continue;
      if (may_collapse(candidate.gone, candidate.kept)) collapse(candidate.gone, candidate.kept);
    }
  }

  std::size_t size() const { return left_; }
  const std::vector<glm::dvec3>& places() const { return places_; }
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> all;
    for (const Triangle& t : triangles_) {
      if (t[0] != t[1]) all.push_back(t);
    }
    return all;
  }
  // The vertex into which vertex `v` of the original was collapsed.
  std::uint32_t place_of(std::uint32_t v) const {
    while (into_[v] != v) v = into_[v];
    return v;
  }
  std::vector<std::uint32_t> neighbours_of(std::uint32_t v) const {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t t : around_[v]) {
      for (const std::uint32_t other : triangles_[t]) {
        if (other != v && std::ranges::count(all, other) == 0) all.push_back(other);
      }
    }
    return all;
  }
  // The triangles at a vertex and at its neighbours.
  std::vector<Triangle> triangles_near(std::uint32_t v) const {
    std::vector<std::uint32_t> indices = around_[v];
    for (const std::uint32_t n : neighbours_of(v))
      indices.insert(indices.end(), around_[n].begin(), around_[n].end());
    std::ranges::sort(indices);
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    std::vector<Triangle> all;
    for (const std::uint32_t t : indices) all.push_back(triangles_[t]);
    return all;
  }

private:
  struct CollapseCandidate {
    double cost;
    std::uint32_t gone, kept, version;
    // The cheapest candidate is on top; candidates with the same cost have a fixed order.
    bool operator<(const CollapseCandidate& other) const {
      return std::tie(cost, gone, kept) > std::tie(other.cost, other.gone, other.kept);
    }
  };

  glm::dvec3 area_vector(const Triangle& t) const {
    return glm::cross(places_[t[1]] - places_[t[0]], places_[t[2]] - places_[t[0]]);
  }

  // Adds up the planes of a vertex's triangles. At the border of the surface it adds planes that
  // are perpendicular to the surface along the border edge; their weight is a hundred times larger,
  // so that the border stays where it is.
  void make_quadrics() {
    constexpr double kEdgeWeight = 100;
    quadrics_.resize(places_.size());
    versions_.assign(places_.size(), 0);
    for (const Triangle& t : triangles_) {
      const glm::dvec3 vector = area_vector(t);
      const double length = glm::length(vector);
      if (length == 0) continue;
      const glm::dvec3 normal = vector / length;
      const Quadric own = Quadric::of_plane(normal, -glm::dot(normal, places_[t[0]]), 1);
      for (const std::uint32_t v : t) quadrics_[v] += own;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (shared_triangles(a, b) != 1) continue;
        const glm::dvec3 across = glm::normalize(glm::cross(places_[b] - places_[a], normal));
        const Quadric wall = Quadric::of_plane(across, -glm::dot(across, places_[a]), kEdgeWeight);
        quadrics_[a] += wall, quadrics_[b] += wall;
      }
    }
  }

  int shared_triangles(std::uint32_t a, std::uint32_t b) const {
    return int(std::ranges::count_if(
        around_[a], [&](std::uint32_t t) { return std::ranges::count(triangles_[t], b) > 0; }));
  }

  void add_candidate(std::uint32_t gone, std::uint32_t kept) {
    Quadric both = quadrics_[gone];
    both += quadrics_[kept];
    candidates_.push({both.at(places_[kept]), gone, kept, versions_[gone] + versions_[kept]});
  }
  void add_candidates_at(std::uint32_t v) {
    for (const std::uint32_t n : neighbours_of(v)) add_candidate(v, n), add_candidate(n, v);
  }

  // If the two vertices have no common neighbours except the third corners of the triangles at
  // their edge, the surface keeps its topology. In addition, no triangle may turn by more than 80
  // degrees.
  bool may_collapse(std::uint32_t gone, std::uint32_t kept) const {
    constexpr double kMinCosine = 0.17;
    if (place_of(gone) != gone || place_of(kept) != kept) return false;
    const int shared = shared_triangles(gone, kept);
    if (shared == 0) return false;
    const std::vector<std::uint32_t> one = neighbours_of(gone), other = neighbours_of(kept);
    const auto common = std::ranges::count_if(
        one, [&](std::uint32_t v) { return std::ranges::count(other, v) > 0; });
    if (common != shared) return false;
    return std::ranges::all_of(around_[gone], [&](std::uint32_t index) {
      Triangle t = triangles_[index];
      if (std::ranges::count(t, kept) > 0) return true;  // this triangle disappears
      const glm::dvec3 before = area_vector(t);
      std::ranges::replace(t, gone, kept);
      const glm::dvec3 after = area_vector(t);
      return glm::dot(before, after) > kMinCosine * glm::length(before) * glm::length(after);
    });
  }

  void collapse(std::uint32_t gone, std::uint32_t kept) {
    for (const std::uint32_t index : around_[gone]) {
      Triangle& t = triangles_[index];
      if (std::ranges::count(t, kept) > 0) {
        for (const std::uint32_t v : t) {
          if (v != gone) std::erase(around_[v], index);
        }
        t = {};
        --left_;
      } else {
        std::ranges::replace(t, gone, kept);
        around_[kept].push_back(index);
      }
    }
    around_[gone].clear();
    into_[gone] = kept;
    quadrics_[kept] += quadrics_[gone];
    ++versions_[kept];
    add_candidates_at(kept);
  }

  std::vector<glm::dvec3> places_;
  std::vector<Triangle> triangles_;                 // {0, 0, 0}: removed
  std::vector<std::vector<std::uint32_t>> around_;  // per vertex: its triangles
  std::vector<std::uint32_t> into_, versions_;
  std::vector<Quadric> quadrics_;
  std::priority_queue<CollapseCandidate> candidates_;
  std::size_t left_ = 0;
};

// The distance from p to the nearest point of a triangle (Ericson 2005, 5.1.5).
inline double distance_to(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                          const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
  const auto to_side = [&](const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 side = to - from;
    const double t =
        std::clamp(glm::dot(p - from, side) / std::max(glm::dot(side, side), 1e-300), 0.0, 1.0);
    return glm::length(p - (from + side * t));
  };
  const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  if (glm::dot(normal, normal) > 0 && inside(a, b) && inside(b, c) && inside(c, a))
    return std::abs(glm::dot(p - a, normal)) / glm::length(normal);
  return std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
}

}  // namespace glassbox::study::d26
