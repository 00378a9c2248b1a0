// glassbox step SCENE --triangle N: see app/step/scene_step.h.
// glassbox step --point x,y,z --model FILE --view FILE --proj FILE: a point through one's own matrices, space by space, with
// a check of each matrix, and where the point vanishes the convention that would make it visible; see app/step/point_step.h.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"
#include "app/step/point_step.h"
#include "app/step/scene_step.h"

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  int run_points();

  SceneStep scene_;
  PointStepOptions points_;
  bool bits_ = false;
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
