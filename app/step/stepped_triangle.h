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
  std::uint32_t triangle = 0;    // number in the whole scene
  std::optional<int> vertex;     // 0, 1 or 2: of the triangle's corners
  std::optional<PixelAt> pixel;  // the fragment to look at

  bool wants(std::size_t corner) const { return !vertex || std::size_t(*vertex) == corner; }
  friend bool operator==(const StepTarget&, const StepTarget&) = default;
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

// Aims at a triangle by its number, or at what a pixel shows; at nothing else where neither is given. An error where there is no
// such triangle or pixel, or nothing is seen there. `dashes`: what the names of options begin with in errors.
Result<void> aim(StepTarget& target, const Scene& scene, const PictureOptions& picture,
                 std::optional<std::uint32_t> triangle, std::optional<PixelAt> pixel,
                 const std::string& dashes);

const TracedDraw& draw_of(const SteppedTriangle& stepped);

}  // namespace glassbox::app
