// A picture drawn from layers, beside what the scene itself looks like from there.
#pragma once

#include <cstddef>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

namespace glassbox::app {

struct LayersAgainst {
  double psnr = 0;        // dB
  std::size_t wrong = 0;  // pixels that differ by more than views::kVisibleDifference in a channel
  std::size_t missing = 0;  // holes where the scene shows something
  std::size_t interior =
      0;  // of these, such in a surface that the layers have there: between its samples
  double render_ms = 0;
};

LayersAgainst against_scene(const views::LayerPicture& picture, const View& view,
                            const Scene& scene, const views::StoredLayers& layers);

}  // namespace glassbox::app
