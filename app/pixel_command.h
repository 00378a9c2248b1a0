// glassbox pixel SCENE --at X,Y: what is seen in one pixel of a picture, and how it came about.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/picture_options.h"

#include <glassbox/images/compare/differences.h>
#include <glassbox/images/recipe.h>
#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class PixelCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();

  std::string scene_;
  PixelAt at_;
  bool all_ = false;  // list all near misses
  PictureOptions picture_;
  LoadLimits limits_;
  std::optional<std::string> json_output_;
};

// The command line that shows pixel (x, y) of the picture that the recipe makes; empty if the recipe, which comes from
// a file, is not one that this program writes.
std::string pixel_command_line(const Recipe& recipe, PixelAt pixel);

}  // namespace glassbox::app
