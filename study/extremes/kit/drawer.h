// Whoever draws pictures: cases that show in one are put to all of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glassbox/render/renderer.h>

namespace glassbox::study {

struct Drawer {
  std::string name;  // "staged", "tile, avx2"
  std::function<Rendering(const Scene&, const View&, const RenderSettings&)> draw;
  // For pairs. The scene must outlive it.
  std::function<Renderer(const Scene&, Transfer)> renderer;
};

// The staged reference; the tile engine for each target that this processor has; and without a plan, for the best of them.
const std::vector<Drawer>& drawers();
Drawer tile_engine(const std::string& name, const TileOptions& options);

}  // namespace glassbox::study
