// Positions and depths of a scene's vertices: how far from the right ones several ways to compute them come.
#pragma once

#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/depth.h>
#include <glassbox/render/engine/draw_list.h>

#include "study/recommend/candidates.h"

namespace glassbox::study {

// Where a vertex is, to the nearest double of 50 digits' answer.
struct RightPlace {
  std::size_t draw = 0;
  std::uint32_t vertex = 0;
  double x = 0, y = 0;  // px
  double distance = 0;  // along the gaze, from the eye
};

// The scene's vertices as one view has them.
class SceneVertices {
public:
  // Looks at `most` vertices that are in the picture, evenly spread over the tables; at those beyond the picture's sides
  // where it has none inside. The scene must outlive it. An error where no vertex is between the near and far planes.
  static Result<SceneVertices> of(const Scene& scene, const View& view, std::size_t most = 4000);

  // The largest distance on the screen of where render snaps a vertex to from where it is, in pixels.
  double position_error() const;
  // Vertex arithmetic and subpixel bits, by their errors alone: render has one way, and what the others would cost it is not what a
  // loop of their own costs.
  Comparison positions() const;
  // The largest error of the distances that a depth buffer of this format gives back: a share of the distance, for parallel
  // projections of the distance between the planes. The view's depth range must be the format's.
  double depth_error(DepthFormat format) const;

  std::size_t count() const { return places_.size(); }

private:
  SceneVertices(const Scene& scene, const View& view);

  const Scene* scene_;
  View view_;
  PreparedScene prepared_;
  DrawList list_;
  std::vector<RightPlace> places_;
};

}  // namespace glassbox::study
