// Finds the clusters of a draw that an eye does not see: those outside the view, and those whose
// triangles are all turned away.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/clusters.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/object_cull.h>

namespace glassbox {

enum class ClusterVerdict : std::uint8_t { kDrawn, kOutside, kTurnedAway };

class ClusterCull {
public:
  // `uncut`: no clipping plane cuts anything of the draw.
  ClusterCull(const Draw& draw, const View& view, Cull cull, bool uncut);

  ClusterVerdict classify(const Cluster& cluster) const;

private:
  Vector<Object, double> anchor_;
  std::vector<PlaneOverBoxes> picture_edges_, clip_planes_;
  std::optional<ObjectCull> cull_;
};

}  // namespace glassbox
