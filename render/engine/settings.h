// The settings of a run, apart from the scene and the view.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/raster/blend.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

enum class Shading { kUnlit, kFlat, kGouraud, kPhong };

// kColor shows the picture. The other values show one quantity instead; show_plane.h describes how
// each is coloured.
enum class Show { kColor, kDepth, kNormal, kUv, kId, kOverdraw };

// Which faces are culled. kMaterial: back faces, except those of double-sided materials.
enum class Cull { kMaterial, kBack, kFront, kNone };

// The stage at which faces that are turned away are removed. kScreen: after clipping, by the area
// after snapping. kObject: before clipping, in object space, if it is certain there
// (object_cull.h); all other faces as with kScreen. The picture has the same bytes.
enum class CullStage { kScreen, kObject };

struct RenderSettings {
  Shading shading = Shading::kPhong;
  Show show = Show::kColor;
  Cull cull = Cull::kMaterial;
  CullStage cull_stage = CullStage::kScreen;
  bool wireframe = false;  // draws the edges of triangles instead of their insides
  int samples = 1;         // per pixel: 1, 2, 4, 8 or 16 (docs/pipeline.md)
  DepthFormat depth = DepthFormat::kFloat32;
  Transfer transfer = Transfer::kSrgb;
  Rgba8 background{26, 31, 38, 255};  // as stored in files
  ColorMask mask;
  bool want_depth = false;     // fill Framebuffer::depth; the staged engine always does
  bool want_distance = false;  // fill Framebuffer::distance
  bool want_id = false;        // fill Framebuffer::id
};

// How many samples per pixel are drawn. Pictures of depth, triangle numbers or overdraw use pixel
// centres only.
inline int samples_drawn(const RenderSettings& settings) {
  const Show show = settings.show;
  const bool from_plane = show == Show::kDepth || show == Show::kId || show == Show::kOverdraw;
  return from_plane ? 1 : settings.samples;
}

// Returns the same settings with one sample per pixel, at its centre.
inline RenderSettings with_one_sample(RenderSettings settings) {
  settings.samples = 1;
  return settings;
}

}  // namespace glassbox
