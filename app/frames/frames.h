// render --frames: a picture for every frame of a camera path or of a turn, for two eyes with a separation that adapts.
#pragma once

#include <optional>
#include <string>

#include "app/frames/frames_options.h"
#include "app/options/engine_options.h"
#include "app/options/picture_options.h"
#include "app/options/stereo_picture.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

// What `glassbox render` was asked for. The options count as checked.
struct FramesRequest {
  const std::string& scene;
  const std::string& output;        // -o; empty: named after the scene
  const std::string& usual_output;  // what a single picture would be called
  const PictureOptions& picture;
  const StereoPictureOptions& stereo;
  const FramesOptions& frames;
  const EngineOptions& engine;
  const LoadLimits& limits;
  const std::optional<std::string>& json;
};

// The program's exit code. Pictures are written one by one, each whole.
int render_frames(const FramesRequest& request);

}  // namespace glassbox::app
