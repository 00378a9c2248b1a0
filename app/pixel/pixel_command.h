// glassbox pixel SCENE --at X,Y: shows what is visible in one pixel of a picture, and the history
// of its colour.
#pragma once

#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_question.h"

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/recipe.h>

namespace glassbox::app {

class PixelCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run() const;
  Answer answer(const Scene& scene, const View& view) const;

  PictureQuestion question_;
  PixelAt at_;
  bool all_ = false;  // list all triangles that narrowly miss the pixel's centre
};

// The command line that shows pixel (x, y) of the picture that the recipe makes. Empty if the
// recipe, which comes from a file, is not one that this program writes.
std::string pixel_command_line(const Recipe& recipe, PixelAt pixel);

}  // namespace glassbox::app
