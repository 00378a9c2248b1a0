// Intersects rays with triangles: a tree of boxes, and a test that lets no ray through between
// triangles that share an edge.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace glassbox::views {

struct Ray {
  Eigen::Vector3f origin;     // in float, because the test of the boxes computes in float
  Eigen::Vector3d direction;  // of any length but 0
};

struct RayHit {
  double distance = std::numeric_limits<double>::infinity();  // in units of the direction's length
  std::uint32_t triangle = 0;
  std::array<double, 3> weights{};  // of the corners in the hit point, none below 0
  bool front = true;  // whether the corners are counter-clockwise as seen from the ray's origin
};

using TriangleCorners = std::array<Eigen::Vector3d, 3>;

// A ray prepared for the triangle test: sheared so that it runs along its longest axis (Woop,
// Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2013). For an edge that two
// triangles share, both tests compute the edge function from the same products, so a ray there hits
// at least one of the two triangles; a ray exactly on the edge hits both.
class ShearedRay {
public:
  explicit ShearedRay(const Ray& ray);
  // The hit, if it is in front of the origin; edges count as inside.
  std::optional<RayHit> intersect(const TriangleCorners& corners) const;

private:
  Eigen::Vector3d origin_;
  int x_, y_, z_;  // the axes, reordered so that the direction's longest component is along z_
  double shear_x_, shear_y_, shear_z_;
};

class RayCaster {
public:
  // The triangles must be finite.
  explicit RayCaster(std::vector<TriangleCorners> triangles);

  const TriangleCorners& corners(std::uint32_t triangle) const { return triangles_[triangle]; }
  // The point of the hit, as a mean of the triangle's corners: on the triangle to within 8 u (the
  // unit roundoff, 2^-53) of the largest coordinate.
  Eigen::Vector3d hit_point(const RayHit& hit) const;

  // The nearest hit for which `accepts(hit)` is true, at most at the distance `within`; of several
  // at one distance, the one on the triangle with the lowest number.
  template <class Accepts>
  std::optional<RayHit> cast(const Ray& ray, const Accepts& accepts,
                             double within = std::numeric_limits<double>::infinity()) const;

private:
  // An inner node of the tree. It has two boxes, and for each its contents: `count` triangles of
  // order_ from `first` on, or, if `count` is 0, the node `first`.
  struct Node {
    std::array<std::array<float, 3>, 2> low, high;
    std::array<std::uint32_t, 2> first, count;
  };
  // A node, or a group of triangles, that is still to be visited, and the distance from which on it
  // may contain a hit.
  struct Visit {
    std::uint32_t first, count;
    float from;
  };
  // The reciprocals of the direction's components. A component below 2^-60 of the largest one is
  // replaced by 2^-60 of it: over any distance this moves the ray by less than the boxes are
  // enlarged.
  struct BoxRay {
    explicit BoxRay(const Ray& ray);
    std::array<float, 3> origin, inverse;
  };
  friend class RayTree;

  // The most entries of the list of visits; see the static_assert in ray_caster.cpp.
  static constexpr int kDeepest = 96;

  // The distance at which the ray enters the box, or infinity if it misses the box. A distance is
  // computed with three roundings (a difference, a reciprocal and their product), each with a
  // relative error of 2^-24: 3 * 2^-24 in all. So the interval of distances inside the box is
  // widened by 2^-21 at both ends (Ize, "Robust BVH Ray Traversal", JCGT 2013).
  static float entry_distance(const Node& node, std::size_t side, const BoxRay& ray) {
    constexpr float kWider = 1 + 0x1p-21f, kNarrower = 1 - 0x1p-21f;
    float from = 0, to = std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float a = (node.low[side][axis] - ray.origin[axis]) * ray.inverse[axis];
      const float b = (node.high[side][axis] - ray.origin[axis]) * ray.inverse[axis];
      const float less = a < b ? a : b, more = a < b ? b : a;
      from = less > from ? less : from;
      to = more < to ? more : to;
    }
    return from * kNarrower <= to * kWider ? from * kNarrower
                                           : std::numeric_limits<float>::infinity();
  }

  std::vector<TriangleCorners> triangles_;
  std::vector<std::uint32_t> order_;
  // From the root on; empty if there are so few triangles that all of them are tested.
  std::vector<Node> nodes_;
};

template <class Accepts>
std::optional<RayHit> RayCaster::cast(const Ray& ray, const Accepts& accepts, double within) const {
  const BoxRay box_ray(ray);
  const ShearedRay sheared(ray);
  RayHit nearest;
  nearest.distance = within;
  bool found = false;
  std::array<Visit, kDeepest> left;
  std::size_t count = 0;
  if (nodes_.empty()) {
    if (!order_.empty()) left[count++] = {0, std::uint32_t(order_.size()), 0};
  } else {
    left[count++] = {0, 0, 0};
  }
  while (count > 0) {
    const Visit visit = left[--count];
    if (double(visit.from) > nearest.distance) continue;
    if (visit.count > 0) {
      for (std::uint32_t i = visit.first; i < visit.first + visit.count; ++i) {
        auto hit = sheared.intersect(triangles_[order_[i]]);
        if (!hit || hit->distance > nearest.distance) continue;
        hit->triangle = order_[i];
        if (found && hit->distance == nearest.distance && hit->triangle > nearest.triangle)
          continue;
        if (!accepts(*hit)) continue;
        nearest = *hit;
        found = true;
      }
      continue;
    }
    const Node& node = nodes_[visit.first];
    const std::array<float, 2> from{entry_distance(node, 0, box_ray),
                                    entry_distance(node, 1, box_ray)};
    const std::size_t far = from[0] > from[1] ? 0 : 1;
    for (const std::size_t side : {far, 1 - far}) {  // the nearer one is visited first
      if (from[side] < std::numeric_limits<float>::infinity() &&
          double(from[side]) <= nearest.distance)
        left[count++] = {node.first[side], node.count[side], from[side]};
    }
  }
  if (!found) return std::nullopt;
  return nearest;
}

}  // namespace glassbox::views
