// glassbox views layers draw: draws a layered depth image from one or many other views, and reports
// the difference from the true picture.
#pragma once

#include <optional>
#include <string>

#include "cli/frames/frames_options.h"
#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/options/cli_fwd.h"
#include "views/commands/layers_against.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

namespace glassbox::views {

class LayersDrawCommand {
public:
  void add_to(CLI::App& layers, int& exit_code);

private:
  struct Times {
    double median_ms = 0, lower_ms = 0;  // over `count` pictures; lower_ms is the lower quartile
    double processor_ms = 0;             // lower quartile of the time of all threads together
    int count = 1;
  };
  struct Drawn {
    views::LayerPicture picture;
    Times times;
    std::optional<LayersAgainst> against;
  };

  int run();
  Result<void> check_options() const;
  Result<Drawn> draw(const views::StoredLayers& layers, Progress& progress);
  int run_frames(const views::StoredLayers& layers, Progress& progress);
  int report(const Drawn& drawn) const;

  const CLI::App* command_ = nullptr;  // tells which options were given
  std::string file_;
  std::optional<std::string> output_, page_;
  std::optional<Size> size_;
  CameraOptions camera_;
  FramesOptions frames_;
  views::LayerDrawing drawing_;
  std::optional<Rgba8> holes_;
  std::optional<int> repeat_;
  std::optional<std::string> against_, json_output_;
};

}  // namespace glassbox::views
