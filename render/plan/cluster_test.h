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

class ClusterTest {
public:
  ClusterTest(const Draw& draw, const View& view, Cull cull);

  ClusterVerdict judge(const Cluster& cluster) const;

private:
  // slope . p + offset >= 0 for p relative to the anchor; and what the vertices' float transform may be off by, error . (|p|, 1).
  struct HalfSpace {
    Vector<Object, double> slope, error;
    double offset = 0, error_offset = 0;
  };
  static HalfSpace half_space(const ClipPlane& plane, const Transform<Clip, Object, float>& m);

  Vector<Object, double> anchor_;
  std::vector<HalfSpace> picture_edges_, clip_planes_;
  std::optional<ObjectCull> cull_;
};

}  // namespace glassbox
