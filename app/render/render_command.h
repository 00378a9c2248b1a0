// glassbox render SCENE: draws a picture, and writes other planes of the framebuffer if asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/stereo/stereo_picture.h"
#include "cli/frames/frames_options.h"
#include "cli/options/cli_fwd.h"
#include "cli/options/engine_options.h"
#include "cli/options/picture_options.h"
#include "cli/report/picture_output.h"

#include <glassbox/base/error.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/statistics.h>

namespace glassbox::app {

struct DrawnPicture;

// Milliseconds.
struct RunTimes {
  double load_ms = 0, total_ms = 0;
};

class RenderCommand {
public:
  // Adds the subcommand. When it runs, its result is stored in `exit_code`.
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  // Draws the frames of a camera path.
  int run_frames(const std::string& usual_output);
  Result<DrawnPicture> draw(const Scene& scene, Renderer& renderer) const;
  std::vector<TextEntry> recipe_text() const;
  Result<void> write_pictures(const std::string& image, const DrawnPicture& drawn) const;
  Result<void> write_error_report(const Scene& scene, Renderer& renderer,
                                  const DrawnPicture& drawn) const;
  std::string stats_text(const DrawnPicture& drawn, const RunTimes& times) const;
  // Prints what is to be reported when all files are written. Returns the exit code.
  int report(const std::string& image, const DrawnPicture& drawn, const RunTimes& times) const;
  // Checks the paths of all outputs as far as possible before anything is computed.
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
  std::optional<std::string> report_output_;
  bool stats_ = false;
};

}  // namespace glassbox::app
