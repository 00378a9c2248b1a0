// Warnings of `glassbox info` about numerical errors that would be visible in the usual view.
// Nothing is drawn.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// One line per warning, for the view that `glassbox render SCENE` draws: the scene's first camera,
// or else the whole scene framed. None if there is no such view.
std::vector<std::string> stiffness_of_framed(const Scene& scene);

}  // namespace glassbox::app
