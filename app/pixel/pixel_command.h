// glassbox pixel SCENE --at X,Y: shows what is visible in one pixel of a picture, and the history
// of its colour.
#pragma once

#include <string>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/recipe.h>

namespace glassbox::app {

// The command line that shows pixel (x, y) of the picture that the recipe makes. Empty if the
// recipe, which comes from a file, is not one that this program writes.
std::string pixel_command_line(const Recipe& recipe, PixelPosition pixel);

}  // namespace glassbox::app
