// One draw of the list carried through all stages: for one eye, or for the two of a stereo pair at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glassbox/render/draw_list.h>
#include <glassbox/render/framebuffer.h>
#include <glassbox/render/observer.h>
#include <glassbox/render/settings.h>
#include <glassbox/render/statistics.h>

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

// The draw of that index, for one or two eyes. Positions, normals and the light on corners are computed once, and counted
// and timed with the first eye.
void render_draw(std::size_t index, const Lighting& lighting, std::span<const EyePass> eyes);

}  // namespace glassbox
