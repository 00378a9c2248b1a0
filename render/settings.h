// What a run is asked for, besides the scene and the view.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/raster/blend.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

enum class Shading { kUnlit, kFlat, kGouraud, kPhong };

// kColor: the picture. The others show one quantity in its place: see show.h for how each is coloured.
enum class Show { kColor, kDepth, kNormal, kUv, kId, kOverdraw };

// kMaterial: back faces, except of double-sided materials.
enum class Cull { kMaterial, kBack, kFront, kNone };

struct RenderSettings {
  Shading shading = Shading::kPhong;
  Show show = Show::kColor;
  Cull cull = Cull::kMaterial;
  bool wireframe = false;  // the edges of triangles instead of their insides
  DepthFormat depth = DepthFormat::kFloat32;
  Transfer transfer = Transfer::kSrgb;
  Rgba8 background{26, 31, 38, 255};  // stored bytes
  ColorMask mask;
  bool want_depth = false;     // fill Framebuffer::depth; the staged driver always does
  bool want_distance = false;  // fill Framebuffer::distance
  bool want_id = false;        // fill Framebuffer::id
};

}  // namespace glassbox
