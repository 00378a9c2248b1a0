// glassbox views layers draw: a layered depth image from another view, and how far off the truth it is.
#pragma once

#include <optional>
#include <string>

#include "app/options/arguments.h"
#include "app/options/camera_options.h"
#include "app/options/cli_fwd.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

namespace glassbox::app {

class LayersDrawCommand {
public:
  void add_to(CLI::App& layers, int& exit_code);

private:
  // Beside what the scene itself looks like from there.
  struct Against {
    double psnr = 0;          // dB
    std::size_t wrong = 0;    // pixels that differ by more than 8/255 in a channel
    std::size_t missing = 0;  // holes where the scene shows something
    double render_ms = 0;
  };

  int run();
  Result<View> choose_view(const views::StoredLayers& layers) const;
  Result<Against> compare(const views::LayerPicture& picture, const View& view,
                          const views::StoredLayers& layers) const;

  std::string file_, output_;
  std::optional<Size> size_;
  CameraOptions camera_;
  views::LayerDrawing drawing_;
  std::optional<Rgba8> holes_;
  std::optional<std::string> against_, json_output_;
};

}  // namespace glassbox::app
