// Which triangles of a draw are submitted to the eyes of a pair.
#pragma once

#include <span>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/engine.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

class CullingList {
public:
  // `left_draws` are those of the left eye.
  CullingList(StereoCulling how, const View& centre, const std::vector<Draw>& left_draws);

  // Of a draw that was transformed for both eyes. The span holds until the next call.
  std::span<const Triangle> triangles_of(std::size_t draw, const DrawTables& tables);

  NotSubmitted left_out() const { return left_out_; }

private:
  std::vector<Outcode> outcodes_of_pair(const DrawTables& tables) const;
  std::vector<Outcode> outcodes_of_centre(const Draw& centre_draw) const;

  const View& centre_;
  const std::vector<Draw>& draws_;
  std::vector<Draw> centre_draws_;  // empty with kUnion
  std::vector<Triangle> kept_;
  NotSubmitted left_out_;
};

}  // namespace glassbox
