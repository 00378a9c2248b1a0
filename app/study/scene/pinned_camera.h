// The camera that was chosen for a scene, in words: so that other levels of the scene are seen by the same one.
#pragma once

#include <string>
#include <vector>

#include "app/options/picture_options.h"

#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// The picture's options with this camera in place of whatever chose it.
PictureOptions pinned(PictureOptions picture, const Camera& camera);

// And the words that say the same: those given, but for the camera's.
std::vector<std::string> pinned_words(const PictureOptions& given, const PictureOptions& pinned);

}  // namespace glassbox::app
