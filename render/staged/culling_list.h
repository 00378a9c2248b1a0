// Chooses the triangles of a draw that are drawn for the eyes of a pair.
#pragma once

#include <span>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/culling.h>
#include <glassbox/render/engine/engine.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

class CullingList {
public:
  // `as_lines`: only the edges of triangles are drawn, as lines, which reach beyond the triangles.
  CullingList(StereoCulling how, const View& centre, const std::vector<Draw>& left_draws,
              const std::vector<Draw>& right_draws, bool as_lines);

  // Decides which triangles of a draw are drawn; called once for each draw. `left` has the draw's
  // vertices for the left eye; for the right eye, which differs only in x, x is computed here.
  void cull_draw(std::size_t draw, const ClipTable& left);

  std::span<const Triangle> triangles_of(std::size_t draw) const { return kept_[draw]; }
  PairCullCounts counts() const { return counts_; }

private:
  // Returns the outcode of the point for the picture, with a margin if lines are drawn.
  Outcode outcode_within(StereoClipPoint point) const;
  std::vector<Outcode> outcodes_of_pair(const Draw& right_draw, const ClipTable& left) const;
  std::vector<Outcode> outcodes_of_centre(const Draw& centre_draw) const;

  const View& centre_;
  const std::vector<Draw>&left_draws_, &right_draws_;
  // The size of the picture with its margin for lines, divided by the size of the picture.
  double share_x_ = 1, share_y_ = 1;
  std::vector<Draw> centre_draws_;           // for the camera between the eyes; empty with kUnion
  std::vector<std::vector<Triangle>> kept_;  // for each draw, the triangles that are drawn
  PairCullCounts counts_;
};

}  // namespace glassbox
