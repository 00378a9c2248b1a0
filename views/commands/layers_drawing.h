// The views for `glassbox views layers draw`: single views, and sequences of views (frames).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/frames/frames_options.h"
#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/report/progress.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::views {

// Interprets camera options for a file of layers: the samples are the scene, and their camera is
// the scene's camera.
class LayersView {
public:
  LayersView(const views::StoredLayers& layers, const CameraOptions& camera,
             std::optional<Size> size, bool turntable = false);

  Result<View> view() const;
  const Scene& scene() const { return scene_; }
  Size size() const { return size_; }

private:
  // A scene of points: all samples of the layers, if a camera has to be chosen that shows all of
  // them; otherwise two corners of the box around them.
  Scene scene_;
  CameraOptions camera_;
  Size size_;
};

struct LayersFramesRequest {
  const std::string& output;
  const CameraOptions& camera;
  std::optional<Size> size;
  const FramesOptions& frames;
  const views::LayerDrawing& drawing;
};

struct LayersFrame {
  int number = 1;
  std::string picture;
  std::size_t holes = 0;
  double warp_ms = 0;
};

// Draws the frames and writes them one by one, each completely or not at all.
Result<std::vector<LayersFrame>> draw_layer_frames(const LayersFramesRequest& asked,
                                                   const views::StoredLayers& layers,
                                                   Progress& progress);

// Compares a picture drawn from layers with a picture of the scene itself from the same view.
struct LayersComparison {
  double psnr = 0;        // dB
  std::size_t wrong = 0;  // pixels that differ by more than views::kVisibleDifference in a channel
  std::size_t missing = 0;  // holes where the scene is visible
  // The holes whose surface is contained in the layers: gaps between its samples.
  std::size_t interior = 0;
  double render_ms = 0;
};

LayersComparison compare_with_scene(const views::LayerPicture& picture, const View& view,
                                    const Scene& scene, const views::StoredLayers& layers);

// The page of glassbox views layers draw --html: it shows the layers side by side, and draws them
// from views that the reader chooses.

// Makes the page. `file` is the name that it shows for the layers. An error if the layers have too
// many samples for a browser.
Result<std::string> make_layers_page(const views::StoredLayers& layers, const std::string& file);

}  // namespace glassbox::views
