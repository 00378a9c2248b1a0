// One draw of the list carried through the stages: for one eye, or for the two of a stereo pair at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

// One eye's part in a run. The eyes of a pair agree in everything but: the view's clip_from_eye and each draw's
// clip_from_anchored, both in the row of x only; the settings' mask; and where things are written.
struct EyePass {
  const std::vector<Draw>& draws;
  const View& view;
  const RenderSettings& settings;
  Framebuffer& target;
  Image<Rgba8>& color;  // target.color, or that which the eyes of an anaglyph share
  Statistics& statistics;
  Observer* observer = nullptr;
};

// Triangles are carried through the stages in batches, each followed by its fragments, so that each stage can be timed and
// memory stays small.
inline constexpr std::size_t kTriangleBatch = 1024;

// What the vertex stage makes of a draw.
struct DrawTables {
  std::vector<ClipTable> clip;  // by eye
  EyeSpaceTables eye_space;     // of all eyes
};

// Work done for all eyes at once is counted and timed with the first.
DrawTables transform_draw(std::size_t index, std::span<const EyePass> eyes);

// The other stages, for some of the draw's triangles, in the order of the mesh, and for all its lines and points. The light
// on corners is computed once for all eyes.
void draw_primitives(std::size_t index, const DrawTables& tables,
                     std::span<const Triangle> triangles, const Lighting& lighting,
                     std::span<const EyePass> eyes);

}  // namespace glassbox
