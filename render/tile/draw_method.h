// Which way a draw takes through the tile engine, and what of its stages is left out.
#pragma once

#include <glassbox/raster/lanes/tables.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/settings.h>

namespace glassbox {

struct DrawMethod {
  // Null: triangles run over lanes and are shaded once for each pixel where they are seen. Otherwise why every primitive takes the
  // staged stages, tile by tile.
  const char* staged_because = nullptr;
  // Null: triangles are set up over lanes where they are small. Otherwise why each is made ready by the staged primitives.
  const char* large_because = nullptr;

  LightAt light = LightAt::kNowhere;
  bool highlights = false;     // the material has any
  bool eye_positions = false;  // light asks where the surface is
  bool texture = false;
  bool vertex_colors = false;
  bool keep_front = true, keep_back = false;  // facing: which are drawn
};

DrawMethod choose_method(const Draw& draw, const Lighting& lighting,
                         const RenderSettings& settings);

}  // namespace glassbox
