// glassbox explain SCENE: what went into every stage, what came out, and how long it took.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/picture_options.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class ExplainCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();

  std::string scene_;
  PictureOptions picture_;
  LoadLimits limits_;
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
