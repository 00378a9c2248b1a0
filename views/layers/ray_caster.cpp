#include "views/layers/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace glassbox::views {

namespace {

constexpr std::uint32_t kMaxInLeaf = 4;
// Splits on the first levels of the tree, up to this many, may be uneven. Deeper splits halve the
// number of triangles, so that 32 more levels are enough for any number.
constexpr int kUnevenSplits = 60;

struct TreeBox {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;

  void include(const TreeBox& box) {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  void include(const Eigen::Vector3d& p) { include(TreeBox{p, p}); }
  double half_area() const {
    const Eigen::Vector3d s = high - low;
    return s.x() < 0 ? 0 : s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
  }
};

TreeBox box_of(const TriangleCorners& corners) {
  TreeBox box;
  for (const Eigen::Vector3d& corner : corners) box.include(corner);
  return box;
}

}  // namespace

ShearedRay::ShearedRay(const Ray& ray) : origin_(ray.origin.cast<double>()) {
  ray.direction.cwiseAbs().maxCoeff(&z_);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  // If the ray runs backwards along its longest axis, the triangles would appear mirrored.
  // Exchanging the other two axes keeps their winding.
  if (ray.direction[z_] < 0) std::swap(x_, y_);
  shear_x_ = ray.direction[x_] / ray.direction[z_];
  shear_y_ = ray.direction[y_] / ray.direction[z_];
  shear_z_ = 1 / ray.direction[z_];
}

std::optional<RayHit> ShearedRay::intersect(const TriangleCorners& corners) const {
  std::array<double, 3> x, y, z;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d from_origin = corners[k] - origin_;
    x[k] = from_origin[x_] - shear_x_ * from_origin[z_];
    y[k] = from_origin[y_] - shear_y_ * from_origin[z_];
    z[k] = shear_z_ * from_origin[z_];
  }
  const double u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2],
               w = x[1] * y[0] - y[1] * x[0];
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double area = u + v + w;
  if (area == 0) return std::nullopt;  // the triangle is seen edge on
  RayHit hit;
  hit.weights = {u / area, v / area, w / area};
  hit.distance = hit.weights[0] * z[0] + hit.weights[1] * z[1] + hit.weights[2] * z[2];
  hit.front = area > 0;
  if (!(hit.distance > 0) || !std::isfinite(hit.distance)) return std::nullopt;
  return hit;
}

// Builds the tree from the root down by the surface area heuristic, with sixteen bins for each axis
// (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).
class RayTree {
public:
  explicit RayTree(RayCaster& caster) : caster_(caster) {
    double largest = 0;
    for (const TriangleCorners& corners : caster.triangles_) {
      const TreeBox box = box_of(corners);
      boxes_.push_back(box);
      middles_.push_back(0.5 * box.low + 0.5 * box.high);
      largest = std::max({largest, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
    }
    margin_ = 0x1p-22 * largest;
    caster.order_.resize(boxes_.size());
    std::iota(caster.order_.begin(), caster.order_.end(), 0u);
    const auto all = std::uint32_t(boxes_.size());
    if (all <= kMaxInLeaf) return;
    caster.nodes_.emplace_back();
    fill(0, {0, split(0, all, 0), all}, 1);
  }

private:
  // Fills node `number`: one child gets the triangles of order_ from the first to the second place,
  // the other those from the second to the third.
  void fill(std::uint32_t number, const std::array<std::uint32_t, 3>& places, int depth) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::uint32_t begin = places[side], end = places[side + 1];
      RayCaster::Node node = caster_.nodes_[number];
      set_box(node, side, box_of_range(begin, end));
      const bool is_leaf = end - begin <= kMaxInLeaf;
      node.first[side] = is_leaf ? begin : std::uint32_t(caster_.nodes_.size());
      node.count[side] = is_leaf ? end - begin : 0;
      caster_.nodes_[number] = node;
      if (is_leaf) continue;
      caster_.nodes_.emplace_back();
      fill(node.first[side], {begin, split(begin, end, depth), end}, depth + 1);
    }
  }

  TreeBox box_of_range(std::uint32_t begin, std::uint32_t end) const {
    TreeBox box;
    for (std::uint32_t i = begin; i < end; ++i) box.include(boxes_[caster_.order_[i]]);
    return box;
  }

  // Stores a box in floats, enlarged by 2^-22 of the largest coordinate, which is more than the
  // rounding error of 2^-24 of it.
  void set_box(RayCaster::Node& node, std::size_t side, const TreeBox& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      node.low[side][std::size_t(axis)] = float(box.low[axis] - margin_);
      node.high[side][std::size_t(axis)] = float(box.high[axis] + margin_);
    }
  }

  // Reorders the triangles of a range so that each side of the best split is contiguous, and
  // returns where the second side begins: after `begin` and before `end`.
  std::uint32_t split(std::uint32_t begin, std::uint32_t end, int depth) {
    const auto range = std::span(caster_.order_).subspan(begin, end - begin);
    TreeBox middles;
    for (const std::uint32_t i : range) middles.include(middles_[i]);
    int best_axis = -1, best_bin = 0;
    if (depth < kUnevenSplits) {
      double best_cost = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 3; ++axis) {
        if (!(middles.high[axis] > middles.low[axis])) continue;
        const auto [cost, bin] = cheapest(range, middles, axis);
        if (cost < best_cost) best_cost = cost, best_axis = axis, best_bin = bin;
      }
    }
    if (best_axis < 0) return begin + (end - begin) / 2;
    const auto second = std::partition(range.begin(), range.end(), [&](std::uint32_t i) {
      return bin_of(middles_[i], middles, best_axis) < best_bin;
    });
    return begin + std::uint32_t(second - range.begin());
  }

  static constexpr int kBins = 16;
  static int bin_of(const Eigen::Vector3d& middle, const TreeBox& middles, int axis) {
    const double along =
        (middle[axis] - middles.low[axis]) / (middles.high[axis] - middles.low[axis]);
    return std::min(kBins - 1, int(along * kBins));
  }

  // Finds the best split along an axis: returns its cost, and the number of the bin before which it
  // is. The cost is infinite if one side would be empty.
  std::pair<double, int> cheapest(std::span<const std::uint32_t> range, const TreeBox& middles,
                                  int axis) const {
    std::array<TreeBox, kBins> boxes;
    std::array<double, kBins> counts{};
    for (const std::uint32_t i : range) {
      const auto bin = std::size_t(bin_of(middles_[i], middles, axis));
      boxes[bin].include(boxes_[i]);
      ++counts[bin];
    }
    std::array<double, kBins> behind{};  // for each bin, the cost of the triangles from it on
    TreeBox box;
    double count = 0;
    for (std::size_t bin = kBins; bin-- > 1;) {
      box.include(boxes[bin]);
      count += counts[bin];
      behind[bin] = count > 0 ? count * box.half_area() : std::numeric_limits<double>::infinity();
    }
    std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
    box = {};
    count = 0;
    for (std::size_t bin = 1; bin < kBins; ++bin) {
      box.include(boxes[bin - 1]);
      count += counts[bin - 1];
      const double cost = count * box.half_area() + behind[bin];
      if (count > 0 && cost < best.first) best = {cost, int(bin)};
    }
    return best;
  }

  // Visiting a node removes one entry from the list of visits and adds at most two, so at each
  // level the list grows by at most one. Besides the uneven levels, halving 2^32 triangles takes 32
  // levels.
  static_assert(kUnevenSplits + 32 + 2 <= RayCaster::kDeepest);

  RayCaster& caster_;
  std::vector<TreeBox> boxes_;
  std::vector<Eigen::Vector3d> middles_;
  double margin_ = 0;
};

RayCaster::RayCaster(std::vector<TriangleCorners> triangles) : triangles_(std::move(triangles)) {
  RayTree(*this);
}

RayCaster::BoxRay::BoxRay(const Ray& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const double along = ray.direction[axis] / ray.direction.cwiseAbs().maxCoeff();
    const double least = std::copysign(std::max(std::abs(along), 0x1p-60), along);
    const auto i = std::size_t(axis);
    origin[i] = ray.origin[axis];
    inverse[i] = float(1 / (least * ray.direction.cwiseAbs().maxCoeff()));
  }
}

Eigen::Vector3d RayCaster::hit_point(const RayHit& hit) const {
  const TriangleCorners& corners = triangles_[hit.triangle];
  return hit.weights[0] * corners[0] + hit.weights[1] * corners[1] + hit.weights[2] * corners[2];
}

}  // namespace glassbox::views
