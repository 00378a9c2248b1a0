// Which triangles of a draw are submitted to the eyes of a pair.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/staged/draw_pass.h>
#include <glassbox/render/stereo/render_pair.h>

namespace glassbox {

class CullingList {
public:
  // `left_draws` are those of the left eye.
  CullingList(StereoCulling how, const Scene& scene, const View& centre,
              const std::vector<Draw>& left_draws);

  // Of a draw that transform_draw has transformed for both eyes. The span holds until the next call.
  std::span<const Triangle> triangles_of(std::size_t draw, const DrawTables& tables);

  std::uint64_t culled() const { return culled_; }
  // Culled, although the frustum of an eye may show them.
  std::uint64_t lost() const { return lost_; }

private:
  std::vector<Outcode> outcodes_of_pair(const DrawTables& tables) const;
  std::vector<Outcode> outcodes_of_centre(const Draw& centre_draw) const;

  const View& centre_;
  const std::vector<Draw>& draws_;
  std::vector<Draw> centre_draws_;  // empty with kUnion
  std::vector<Triangle> kept_;
  std::uint64_t culled_ = 0, lost_ = 0;
};

}  // namespace glassbox
