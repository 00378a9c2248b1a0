// A triangle of a scene, followed through every stage for one camera, as `glassbox step SCENE`
// shows it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/formulation.h>
#include <glassbox/render/engine/object_cull.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox::app {

struct StepTarget {
  std::uint32_t triangle = 0;          // number in the whole scene
  std::optional<int> vertex;           // 0, 1 or 2: the corner to show; absent: all three
  std::optional<PixelPosition> pixel;  // the fragment to look at

  bool wants(std::size_t corner) const { return !vertex || std::size_t(*vertex) == corner; }
  friend bool operator==(const StepTarget&, const StepTarget&) = default;
};

struct SteppedTriangle {
  ChosenView chosen;
  Formulation formulation;         // how the two matrices of `chosen` were computed
  std::optional<View> usual_view;  // the view by the usual formulation; absent if `chosen` has it
  Trace trace;                     // of this triangle only
  NumberedTriangle place;
  // Absent if the triangle has no area in object space, so that it is not drawn.
  std::optional<TracedTriangle> triangle;
  DrawBounds draw_bounds;
  TriangleBounds bounds;
  // With --cull-stage object: the result of the test before clipping, or why the test was not made.
  std::optional<ObjectCulling> object_culling;
  int visible_pixels = 0;  // in how many pixels of the finished picture it is visible
};

// Runs the pipeline once for the triangle with this number, which must exist.
Result<SteppedTriangle> step_through(const Scene& scene, const PictureOptions& picture,
                                     std::uint32_t triangle);

// Sets the target to the triangle with the given number, or to the one visible in the given pixel;
// leaves it as it is if neither is given. An error if there is no such triangle or pixel, or if
// nothing is visible there. `dashes` is the prefix of option names in errors.
Result<void> set_step_target(StepTarget& target, const Scene& scene, const PictureOptions& picture,
                             std::optional<std::uint32_t> triangle,
                             std::optional<PixelPosition> pixel, const std::string& dashes);

const TracedDraw& draw_of(const SteppedTriangle& stepped);

// The texts of all stages of a stepped triangle.
struct StageText {
  std::string name;  // one word, which the prompt can jump to: "clip"
  std::string text;  // ends with a line break
};

// The texts from "object" to "picture"; fewer if the triangle ends in an earlier stage.
std::vector<StageText> stage_texts(const Scene& scene, const SteppedTriangle& stepped,
                                   const StepTarget& target, bool bits);

}  // namespace glassbox::app
