// The views that glassbox views layers draw is asked for, and the frames of a sequence of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/frames/frames_options.h"
#include "app/options/arguments.h"
#include "app/options/camera_options.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::app {

class Progress;

// What a camera's options mean among these layers: their samples are the scene, and their camera is its own.
class LayersShots {
public:
  LayersShots(const views::StoredLayers& layers, const CameraOptions& camera,
              std::optional<Size> size, bool turntable = false);

  Result<View> view() const;
  const Scene& scene() const { return scene_; }
  Size size() const { return size_; }

private:
  Scene
      scene_;  // of points: all samples where a camera has to be framed, otherwise corners of the box around them
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

// Draws the frames and writes them one by one, each whole.
Result<std::vector<LayersFrame>> draw_layer_frames(const LayersFrames& asked,
                                                   const views::StoredLayers& layers,
                                                   Progress& progress);

}  // namespace glassbox::app
