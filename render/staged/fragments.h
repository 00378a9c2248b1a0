// Primitives become fragments, and fragments become pixels: coverage, depth test, texture, light, alpha, blend.
#pragma once

#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox {

struct FragmentStage {
  const Draw& draw;
  ColorMask channels;  // that are shaded: shaded_channels(draw, settings)
  const View& view;
  const RenderSettings& settings;
  const Lighting& lighting;
  Framebuffer& target;  // every plane but the colours
  Image<Rgba8>& color;  // the target's own, or that which the eyes of an anaglyph share
  PixelRect window;     // the part of the picture that is drawn
  Statistics& statistics;
  Observer* observer = nullptr;
  SamplePlanes* samples =
      nullptr;  // null: one sample, at the pixel's centre, straight into `color`
};

// Those that are written, and alpha where the material asks for it.
ColorMask shaded_channels(const Draw& draw, const RenderSettings& settings);

void rasterise(const FragmentStage& stage, const ReadyTriangle& triangle);
void rasterise(const FragmentStage& stage, const ReadyLine& line);
void rasterise(const FragmentStage& stage, const ReadyPoint& point);

}  // namespace glassbox
