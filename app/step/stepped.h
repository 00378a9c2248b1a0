// A triangle of a scene, carried through every stage for one camera: what `glassbox step SCENE` shows.
#pragma once

#include <optional>

#include "app/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/formulation.h>
#include <glassbox/render/engine/object_cull.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox::app {

struct StepTarget {
  std::uint32_t triangle = 0;               // number in the whole scene
  std::optional<int> vertex;                // 0, 1 or 2: of the triangle's corners
  std::optional<std::array<int, 2>> pixel;  // the fragment to look at

  bool wants(std::size_t corner) const { return !vertex || std::size_t(*vertex) == corner; }
};

struct SteppedTriangle {
  ChosenView chosen;
  Formulation formulation;    // how the two matrices of `chosen` were made
  std::optional<View> usual;  // the view as it is made otherwise, where that is another way
  Trace trace;                // of this triangle alone
  NumberedTriangle place;
  // None: the triangle has no area as modelled, and is not drawn.
  std::optional<TracedTriangle> triangle;
  DrawBounds draw_bounds;
  TriangleBounds bounds;
  // With --cull-stage object: what the test before clipping says, or why there is none.
  std::optional<ObjectCulling> object_culling;
  int seen = 0;  // pixels of the finished picture that show it
};

// One run. The number exists.
Result<SteppedTriangle> step_through(const Scene& scene, const PictureOptions& picture,
                                     std::uint32_t triangle);

// The number of the triangle that is seen in a pixel; an error where none is.
Result<std::uint32_t> pick(const Scene& scene, const PictureOptions& picture, int x, int y);

const TracedDraw& draw_of(const SteppedTriangle& stepped);

}  // namespace glassbox::app
