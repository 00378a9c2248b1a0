// The data that one draw's primitives need in the stages, and primitives that are ready to be
// rasterised.
#pragma once

#include <array>
#include <optional>

#include <glassbox/pipeline/clip.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/object_cull.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

struct ReadyTriangle {
  TriangleSetup setup;
  std::array<Varyings, 3> vertices;  // attributes, in the order that the setup gives the vertices
  std::uint32_t number = 0;          // number in the whole scene
  std::uint32_t piece = 0;           // index in the fan of triangles that clipping left
};

struct ReadyLine {
  std::array<ScreenVertex, 2> ends;
  std::array<Varyings, 2> vertices;
  std::uint32_t id = 0;  // the value for Framebuffer::id
  FragmentSource source;
};

struct ReadyPoint {
  ScreenVertex position;
  Varyings vertex;
  FragmentSource source;
};

// The data of the stages from the corners to the screen, for one eye.
struct PrimitiveStage {
  const Draw& draw;
  const ClipTable* clip;  // null: vertices are projected when triangles need them
  EyeSpace eye_space;
  const View& view;
  const RenderSettings& settings;
  const Lighting& lighting;
  std::array<ClipPlane, kMaxClipPlanes> planes;  // render_planes(view)
  // Culls triangles before clipping, if no plane cuts them; absent: nothing is culled early.
  std::optional<ObjectCull> object_cull;
};

// The data of the stages from the screen to the pixels.
struct FragmentStage {
  const Draw& draw;
  ColorMask channels;  // the shaded channels: shaded_channels(draw, settings)
  const View& view;
  const RenderSettings& settings;
  const Lighting& lighting;
  Framebuffer& target;    // all images except the colours are written to it
  Image<Rgba8>& color;    // target.color, or a picture that the eyes of an anaglyph share
  PixelRect window;       // the part of the picture that is drawn
  SamplePlanes* samples;  // null: one sample, at the pixel's centre, written to `color`
  const Image<std::uint32_t>* behind_depth = nullptr;  // see EyePicture::behind_depth
};

// Returns the channels that are written, and alpha if the material needs it.
inline ColorMask shaded_channels(const Draw& draw, const RenderSettings& settings) {
  ColorMask channels = settings.mask;
  channels.a = channels.a || draw.material->alpha_mode != AlphaMode::kOpaque;
  return channels;
}

}  // namespace glassbox
