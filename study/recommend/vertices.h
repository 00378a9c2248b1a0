// Measures the errors of a scene's vertex positions and depths, for several ways to compute them.
#pragma once

#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/depth.h>
#include <glassbox/render/engine/draw_list.h>

#include "study/recommend/candidates.h"

namespace glassbox::study {

// The exact place of a vertex: computed with 50 digits and rounded to the nearest double.
struct ExactVertexPlace {
  std::size_t draw = 0;
  std::uint32_t vertex = 0;
  double x = 0, y = 0;  // px
  double distance = 0;  // distance from the eye along the gaze
};

// The vertices of a scene as seen in one view.
class SceneVertices {
public:
  // Takes `most` vertices inside the picture, evenly spread over the meshes' vertices; if there are
  // none, vertices beside the picture. The scene must outlive this object. Returns an error if no
  // vertex is between the near and far planes.
  static Result<SceneVertices> sample(const Scene& scene, const View& view,
                                      std::size_t most = 4000);

  // The largest distance on the screen between the place to which glassbox render snaps a vertex
  // and its exact place, in pixels.
  double position_error() const;
  // Compares kinds of vertex arithmetic and numbers of subpixel bits, by their errors only. They
  // are not timed: glassbox render has only one of them, and the time of a separate loop would not
  // show what another one costs inside render.
  Comparison positions() const;
  // The largest error of the distances that are computed back from a depth buffer of this format,
  // as a fraction of the distance, or for parallel projections of the distance between the planes.
  // The view must have the depth range of the format.
  double depth_error(DepthFormat format) const;

  std::size_t count() const { return places_.size(); }

private:
  SceneVertices(const Scene& scene, const View& view);

  const Scene* scene_;
  View view_;
  PreparedScene prepared_;
  DrawList list_;
  std::vector<ExactVertexPlace> places_;
};

}  // namespace glassbox::study
