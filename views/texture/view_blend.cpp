#include "views/texture/view_blend.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

// The angle between two unit vectors in radians, accurate for small angles too.
double angle_between(const Vector3d& a, const Vector3d& b) {
  return arctan2(a.cross(b).norm(), a.dot(b));
}

void normalise(ViewWeights& weights) {
  double sum = 0;
  for (const ViewWeight& each : weights) sum += each.weight;
  for (ViewWeight& each : weights) each.weight /= sum;
}

// Weights (1 - angle / limit) / angle, where the limit is the angle of the nearest view that is not
// used, or twice the largest angle if all views are used. A weight is 0 at the limit, so that views
// come and go without a jump, and it tends to infinity towards a view's own direction.
ViewWeights lumigraph(const std::vector<std::size_t>& seen, const std::vector<double>& angles,
                      std::size_t count) {
  ViewWeights weights;
  if (angles[seen.front()] == 0 || seen.size() == 1) return {{seen.front(), 1}};
  const bool has_next = seen.size() > count;
  const double limit = has_next ? angles[seen[count]] : 2 * angles[seen.back()];
  for (std::size_t i = 0; i < std::min(count, seen.size()); ++i) {
    const double weight = (1 - angles[seen[i]] / limit) / angles[seen[i]];
    if (weight > 0) weights.push_back({seen[i], weight});
  }
  // All views that are used are as far away as the limit, so that every weight would be 0.
  if (weights.empty()) return {{seen.front(), 1}};
  normalise(weights);
  return weights;
}

}  // namespace

std::string_view name_of(Blend blend) {
  constexpr std::string_view kNames[] = {"nearest", "barycentric", "neighbours"};
  return kNames[std::size_t(blend)];
}

ViewBlend::ViewBlend(Blend blend, std::vector<Vector3d> directions, int neighbours)
    : blend_(blend),
      directions_(std::move(directions)),
      sphere_(directions_),
      neighbours_(std::size_t(neighbours)) {}

ViewBlend::FromDirection::FromDirection(const ViewBlend& blend, const Vector3d& direction)
    : blend_(blend), around_(blend.sphere_.weights(direction)), nearest_(blend.views()) {
  for (const Vector3d& each : blend.directions_) angles_.push_back(angle_between(each, direction));
  std::iota(nearest_.begin(), nearest_.end(), std::size_t(0));
  std::ranges::stable_sort(nearest_, {}, [&](std::size_t view) { return angles_[view]; });
}

ViewWeights ViewBlend::FromDirection::weights(
    const std::function<bool(std::size_t view)>& sees) const {
  if (blend_.blend_ == Blend::kBarycentric) {
    ViewWeights weights;
    for (const ViewWeight& each : around_) {
      if (sees(each.view)) weights.push_back(each);
    }
    if (!weights.empty()) {
      normalise(weights);
      return weights;
    }
  }
  const std::size_t most = blend_.blend_ == Blend::kNeighbours ? blend_.neighbours_ + 1 : 1;
  std::vector<std::size_t> seen;
  for (const std::size_t view : nearest_) {
    if (seen.size() == most) break;
    if (sees(view)) seen.push_back(view);
  }
  if (seen.empty()) return {};
  if (blend_.blend_ == Blend::kNeighbours) return lumigraph(seen, angles_, blend_.neighbours_);
  return {{seen.front(), 1}};
}

}  // namespace glassbox::views
