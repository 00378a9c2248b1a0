// Which clusters of a draw an eye sees nothing of: those that lie outside, and those of which every triangle is turned away.
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
  // `uncut`: no plane that clips cuts anything of the draw.
  ClusterCull(const Draw& draw, const View& view, Cull cull, bool uncut);

  ClusterVerdict judge(const Cluster& cluster) const;

private:
  Vector<Object, double> anchor_;
  std::vector<PlaneOverBoxes> picture_edges_, clip_planes_;
  std::optional<ObjectCull> cull_;
};

}  // namespace glassbox
