#include <glassbox/render/plan/cluster_cull.h>

#include <glassbox/render/plan/box_classification.h>

namespace glassbox {

ClusterCull::ClusterCull(const Draw& draw, const View& view, Cull cull, bool uncut)
    : anchor_(double(draw.anchor.x), double(draw.anchor.y), double(draw.anchor.z)),
      cull_(certain_culling(draw, view, cull).test) {
  for (const ClipPlane& plane : picture_edges(view.viewport, kOutsideMarginPx)) {
    picture_edges_.emplace_back(plane, draw.clip_from_anchored);
  }
  if (uncut) return;
  for (const ClipPlane& plane : render_planes(view)) {
    clip_planes_.emplace_back(plane, draw.clip_from_anchored);
  }
}

ClusterVerdict ClusterCull::classify(const Cluster& cluster) const {
  const Point<Object, double> p = centre_of(cluster);
  const Point<Object, double> centre{p.x - anchor_.x, p.y - anchor_.y, p.z - anchor_.z};
  const Vector<Object, double> half = half_size_of(cluster);
  for (const PlaneOverBoxes& edge : picture_edges_) {
    if (edge.distance_range(centre, half).greatest < 0) return ClusterVerdict::kOutside;
  }
  bool uncut = true;
  for (const PlaneOverBoxes& plane : clip_planes_) {
    const auto [least, greatest] = plane.distance_range(centre, half);
    if (greatest < 0) return ClusterVerdict::kOutside;
    uncut = uncut && least >= 0;
  }
  return uncut && cull_ && cull_->removes_all(cluster) ? ClusterVerdict::kTurnedAway
                                                       : ClusterVerdict::kDrawn;
}

}  // namespace glassbox
