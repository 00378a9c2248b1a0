// glassbox explain SCENE: what the plan leaves out and why; with --analyze, also what went into
// every stage, what came out, and how long it took.
#pragma once

#include "app/stereo/stereo_picture.h"
#include "cli/options/cli_fwd.h"
#include "cli/options/engine_options.h"
#include "cli/options/picture_question.h"

namespace glassbox::app {

class ExplainCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  Result<Answer> answer(const Scene& scene) const;
  Answer explain_staged(const Scene& scene, const View& view) const;
  Answer explain_tiles(const Scene& scene, const View& view) const;
  Result<Answer> explain_pair(const Scene& scene) const;

  PictureQuestion question_;
  StereoPictureOptions stereo_;
  EngineOptions engine_;
  bool analyze_ = false;
};

}  // namespace glassbox::app
