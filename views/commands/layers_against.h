// Compares a picture drawn from layers with a picture of the scene itself from the same view.
#pragma once

#include <cstddef>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

namespace glassbox::views {

struct LayersAgainst {
  double psnr = 0;        // dB
  std::size_t wrong = 0;  // pixels that differ by more than views::kVisibleDifference in a channel
  std::size_t missing = 0;  // holes where the scene is visible
  // of these, holes in a surface that the layers contain, between its samples
  std::size_t interior = 0;
  double render_ms = 0;
};

LayersAgainst against_scene(const views::LayerPicture& picture, const View& view,
                            const Scene& scene, const views::StoredLayers& layers);

}  // namespace glassbox::views
