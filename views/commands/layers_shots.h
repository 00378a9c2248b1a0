// The views for glassbox views layers draw: single ones, and sequences of frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/frames/frames_options.h"
#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/report/progress.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::views {

// Interprets camera options for a file of layers: the samples are the scene, and their camera is
// the scene's camera.
class LayersShots {
public:
  LayersShots(const views::StoredLayers& layers, const CameraOptions& camera,
              std::optional<Size> size, bool turntable = false);

  Result<View> view() const;
  const Scene& scene() const { return scene_; }
  Size size() const { return size_; }

private:
  // points: all samples if a camera has to be framed, otherwise two corners of the box around them
  Scene scene_;
  CameraOptions camera_;
  Size size_;
};

struct LayersFrames {
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
Result<std::vector<LayersFrame>> draw_layer_frames(const LayersFrames& asked,
                                                   const views::StoredLayers& layers,
                                                   Progress& progress);

}  // namespace glassbox::views
