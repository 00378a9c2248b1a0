// render --frames: draws a picture for every frame of a camera path or of a turntable; for two
// eyes, with a separation that adapts to each frame.
#pragma once

#include <optional>
#include <string>

#include "app/stereo/stereo_picture.h"
#include "cli/frames/frames_options.h"
#include "cli/options/engine_options.h"
#include "cli/options/picture_options.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

// The options of `glassbox render`, already checked.
struct FramesRequest {
  const std::string& scene;
  const std::string& output;          // -o; empty: named after the scene
  const std::string& default_output;  // the name that a single picture would get
  const PictureOptions& picture;
  const StereoPictureOptions& stereo;
  const FramesOptions& frames;
  const EngineOptions& engine;
  const LoadLimits& limits;
  const std::optional<std::string>& json;
};

// Draws the sequence and returns the exit code. Pictures are written one by one, each completely or
// not at all.
int render_frames(const FramesRequest& request);

}  // namespace glassbox::app
