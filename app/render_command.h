// glassbox render SCENE: a picture, and the other planes of the framebuffer if asked for.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/engine_options.h"
#include "app/frames/frames_options.h"
#include "app/picture_options.h"
#include "app/picture_output.h"
#include "app/stereo_picture.h"

#include <glassbox/base/error.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/render/framebuffer.h>
#include <glassbox/render/statistics.h>

namespace glassbox::app {

// The picture, and what there is to say about it.
struct DrawnPicture {
  Camera camera;
  View view;  // of the camera between the eyes where there are two
  Image<Rgba8> image;
  Framebuffer planes;
  std::vector<std::pair<std::string, Statistics>>
      stages;  // of each eye; its name is empty where there is one
  std::string eyes_text;
  nlohmann::ordered_json eyes_json;
};

// Milliseconds.
struct RunTimes {
  double load_ms = 0, total_ms = 0;
};

class RenderCommand {
public:
  // Adds the subcommand; when it is chosen, `exit_code` gets its result.
  void add_to(CLI::App& app, int& exit_code);

  // What the bare program does: the teapot, its stages, and what to try next.
  int run_first_time();

private:
  int run();
  // The same along a camera path.
  int run_frames(const std::string& usual_output);
  Result<DrawnPicture> draw(const Scene& scene, Renderer& renderer) const;
  std::vector<TextEntry> recipe_text() const;
  Result<void> write_pictures(const std::string& image, const DrawnPicture& drawn) const;
  std::string stats_text(const DrawnPicture& drawn, const RunTimes& times) const;
  // What there is to say when all is written; the exit code.
  int report(const std::string& image, const DrawnPicture& drawn, const RunTimes& times) const;
  // The paths of all outputs, as far as they can be judged before anything is computed.
  Result<void> check_other_outputs(const std::string& image) const;

  std::string scene_ = "teapot";
  std::string output_;  // empty: named after the scene
  std::optional<StreamFormat> format_;
  PictureOptions picture_;
  StereoPictureOptions stereo_;
  FramesOptions frames_;
  EngineOptions engine_;
  LoadLimits limits_;
  std::optional<std::string> depth_output_;
  std::optional<std::string> id_output_;
  std::optional<std::string> json_output_;
  bool stats_ = false;
  bool first_time_ = false;
};

}  // namespace glassbox::app
