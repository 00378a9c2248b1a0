// glassbox step --point x,y,z --model FILE --view FILE --proj FILE: a point through one's own matrices, space by space, with
// a check of each matrix, and where the point vanishes the convention that would make it visible.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/point_step.h"

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();

  PointStepOptions options_;
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
