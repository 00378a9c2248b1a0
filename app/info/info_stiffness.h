// What info warns of before anything is drawn: numbers of the usual view whose errors can be seen.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// One line for each, of the view that `glassbox render SCENE` draws: the scene's first camera, or the whole scene framed. None
// where there is no such view.
std::vector<std::string> stiffness_of_framed(const Scene& scene);

}  // namespace glassbox::app
