// The engines that draw pictures; each case that shows in a picture is tested with all of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glassbox/render/renderer.h>

namespace glassbox::study {

struct TestedEngine {
  std::string name;  // for example "staged" or "tile, avx2"
  std::function<Rendering(const Scene&, const View&, const RenderSettings&)> draw;
  // Makes a renderer, for stereo pairs. The scene must outlive the renderer.
  std::function<Renderer(const Scene&, Transfer)> renderer;
};

// All engines: the staged reference, the tile engine for each target that this processor supports,
// and the tile engine for the best of these targets once more without a plan.
const std::vector<TestedEngine>& tested_engines();
TestedEngine tile_engine(const std::string& name, const TileOptions& options);

}  // namespace glassbox::study
