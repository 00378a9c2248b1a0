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
  // `left_draws` are those of the left eye. `as_lines`: the edges of triangles are drawn, and lines
  // reach beyond the triangles.
  CullingList(StereoCulling how, const View& centre, const std::vector<Draw>& left_draws,
              bool as_lines);

  // Returns the triangles to draw, for a draw that was transformed for both eyes. The span is valid
  // until the next call.
  std::span<const Triangle> triangles_of(std::size_t draw, const DrawTables& tables);

  NotSubmitted left_out() const { return left_out_; }

private:
  // Returns the outcode of the point for the picture, with a margin if lines are drawn.
  Outcode outcode_within(StereoClipPoint point) const;
  std::vector<Outcode> outcodes_of_pair(const DrawTables& tables) const;
  std::vector<Outcode> outcodes_of_centre(const Draw& centre_draw) const;

  const View& centre_;
  const std::vector<Draw>& draws_;
  double share_x_ = 1, share_y_ = 1;  // relative size of the picture with its margin for lines
  std::vector<Draw> centre_draws_;    // empty with kUnion
  std::vector<Triangle> kept_;
  NotSubmitted left_out_;
};

}  // namespace glassbox
